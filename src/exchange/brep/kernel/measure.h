#pragma once
#include <Eigen/Geometry>
#include <cstddef>

#include "fusee/solid/mesh.h"

class TopoDS_Shape;

class gp_Trsf;

namespace fusee::exchange::brep {

[[nodiscard]] std::size_t count_faces(const TopoDS_Shape& shape);
/// One solid as such, several as a compound of solids.
[[nodiscard]] TopoDS_Shape solids_of(const TopoDS_Shape& shape);
[[nodiscard]] std::size_t count_solids(const TopoDS_Shape& shape);
/// The volume as any client of OpenCASCADE reads it: by its default integral, with at most 61 Gauss points over a whole face in each
/// direction.
[[nodiscard]] double volume_mm3(const TopoDS_Shape& shape);
/// Exactly one solid that is valid by BRepCheck. (For BRepCheck an empty shape is valid too.)
[[nodiscard]] bool is_one_solid(const TopoDS_Shape& shape);
/// True if the shape has at least one solid and is valid by BRepCheck.
[[nodiscard]] bool is_valid(const TopoDS_Shape& shape);
/// The box of the exact surface, to 1e-6 mm [mm].
[[nodiscard]] solid::Box bounding_box(const TopoDS_Shape& shape);
/// That two bodies take both [mm^3]; 0 for those that touch.
[[nodiscard]] double common_volume_mm3(const TopoDS_Shape& a, const TopoDS_Shape& b);

/// A proper rotation and a translation [mm] for OpenCASCADE.
[[nodiscard]] gp_Trsf transform_of(const Eigen::Isometry3d& placement);

}  // namespace fusee::exchange::brep
