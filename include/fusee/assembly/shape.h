#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "fusee/solid/extrusion.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"

/// Bodies that fusee does not make, as simple shapes: drums, shafts, plates, springs.
namespace fusee::assembly {

using solid::Extrusion, solid::RoundHole;

/// About the z axis of the body, from `z_low` to `z_high`. @param bore_radius_mm 0: none
[[nodiscard]] Extrusion round(double radius_mm, double z_low_mm, double z_high_mm, double bore_radius_mm = 0.0);
/// Along `axis` of the body's frame from `from_mm`. @param bore_radius_mm 0: none
[[nodiscard]] Extrusion rod(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& axis, double radius_mm, double length_mm,
                            double bore_radius_mm = 0.0);
/// A box of the body's frame, with holes along z.
[[nodiscard]] Extrusion box(const Eigen::Vector3d& low_mm, const Eigen::Vector3d& high_mm, std::vector<RoundHole> holes = {});

/// In the frame of its body, closed and facing outward; circles within 0.02 mm.
[[nodiscard]] solid::Mesh mesh_of(const Extrusion& shape);
/// In another frame.
[[nodiscard]] solid::Mesh moved(solid::Mesh mesh, const Eigen::Isometry3d& placement);
/// The mirror image of a body in its plane x = 0: shape(p) for p with -x.
[[nodiscard]] Extrusion mirrored(const Extrusion& shape);

/// A body's hull between two heights, for distances: convex.
struct Prism {
    solid::Ring outline_mm;
    double z_low_mm = 0.0, z_high_mm = 0.0;
};
/// A shape placed in the assembly: for shapes along z, round ones as a polygon around them; a box of heights for others.
[[nodiscard]] Prism prism_of(const Extrusion& shape, const Eigen::Isometry3d& placement);
/// A cam as hulls of horizontal layers, larger than it by at most 0.3 % of its radius. @param z_levels_mm heights in the mesh's frame,
/// rising
[[nodiscard]] std::vector<Prism> layers_of(const solid::Mesh& mesh, const std::vector<double>& z_levels_mm);
/// @pre the placement turns z to +z or -z
[[nodiscard]] Prism placed(const Prism& prism, const Eigen::Isometry3d& placement);

/// The disc about the z axis that holds a prism in every turn, as a polygon around it.
[[nodiscard]] Prism disc_around(const Prism& prism);
/// The hull of a prism shifted by `from_mm` and by `to_mm`, both along the plane: all that it passes between them.
[[nodiscard]] Prism hull_between(const Prism& prism, const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm);

/// Distance of two prisms, 0 if they meet, or `most_mm` if it is that much or more.
[[nodiscard]] double distance_mm(const Prism& a, const Prism& b, double most_mm);
/// The same of a straight cable and a prism.
[[nodiscard]] double distance_mm(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm, const Prism& prism, double most_mm);

}  // namespace fusee::assembly
