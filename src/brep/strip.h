#pragma once
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <functional>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/core/units.h"
#include "fusee/solid/mesh.h"

namespace fusee::brep {

/// A line of the section, at every direction psi a point [mm]; C2.
using Rail = std::function<solid::Vec3(double psi)>;

inline constexpr double kAllowed_mm = 2e-4;  ///< of a spline from its rail: a fifth of what the files promise, 0.01 % of an arm of 2 mm

/// A range parted at those of `places` that lie inside.
[[nodiscard]] std::vector<core::Range> parted(core::Range psi, const std::vector<double>& places);
/// `count` parts of a range, equally wide.
[[nodiscard]] std::vector<core::Range> equal_parts(core::Range psi, int count);
/// The groove's range of psi, parted where the working arc begins and ends: there the contour is no smoother than its second derivative.
/// The idle arc of a planar cam, whose radius of curvature swings the most, is parted into `idle_parts`.
[[nodiscard]] std::vector<core::Range> smooth_parts(const cam::Cam& cam, int idle_parts = 1);

[[nodiscard]] gp_Pnt point(const solid::Vec3& p);

/// A band of the lateral surface: rails are its control points across, so that it is straight from one to the next
/// (degree 1) or a true arc (degree 2, rational).
struct Strip {
    std::vector<Rail> rails;
    std::vector<double> weights;
    int degree = 1;
};
[[nodiscard]] Strip ruled(Rail low, Rail high);
/// @param rails begin and end of each arc with the corner of its tangents between: 3, 5, 7 ... of them
/// @param half half the angle of each arc [rad]
[[nodiscard]] Strip arcs(std::vector<Rail> rails, double half);

/// A direction psi and the splines' parameter there.
struct Node {
    double psi = 0.0;  ///< [rad]
    double at = 0.0;   ///< [mm], from 0
};
/// Where the splines of neighbouring strips go through their rails. One set for all, so that neighbours meet in one curve. Their parameter
/// grows half with the rails' length and half with psi: by psi alone a flat stretch, by length alone a sharp bend would be passed in a
/// moment, and integrals over a face that take a fixed number of points would miss it.
struct Nodes {
    std::vector<Node> nodes;                  ///< rising
    std::vector<Node> middles;                ///< by psi half-way from each node to the next, where splines are judged
    double begin_pace = 0.0, end_pace = 0.0;  ///< d at/dpsi at both ends [mm/rad]
};

/// So many nodes that at their middles no rail is left by more than `allowed_mm`; dense where the contour's third derivative jumps.
[[nodiscard]] Nodes nodes_for(const std::vector<Rail>& rails, core::Range psi, double allowed_mm);
/// The cubic spline through the rail at the nodes, with the rail's slopes at its ends.
[[nodiscard]] Handle(Geom_BSplineCurve) spline(const Rail& rail, const Nodes& nodes);
/// Its distance from the rail at the middles.
[[nodiscard]] std::vector<double> deviations_mm(const Rail& rail, const Nodes& nodes);
/// The strip's surface, u across and v along it: OpenCASCADE's default integrals take their number of points from the spans of v.
[[nodiscard]] TopoDS_Face face_of(const Strip& strip, const Nodes& nodes);

}  // namespace fusee::brep
