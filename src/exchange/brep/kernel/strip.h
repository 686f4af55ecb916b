#pragma once
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <functional>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/part.h"

namespace fusee::exchange::brep {

/// A line of the section, at every direction psi a point [mm]; C2.
using Rail = std::function<solid::Vec3(double psi)>;

/// Of a spline from its rail: a fifth of the files' stated accuracy, 0.01 % of an arm of 2 mm. A roller's arm is the slope of its lift,
/// over 0.1 rad at the ends of the law: there a twentieth is as much of it.
[[nodiscard]] double allowed_mm(const cam::Cam& cam);

/// A range divided at those of `places` that lie inside.
[[nodiscard]] std::vector<core::Range> divided(core::Range psi, const std::vector<double>& places);
/// `count` pieces of a range, equally wide.
[[nodiscard]] std::vector<core::Range> equal_pieces(core::Range psi, int count);
/// The groove's range of psi, divided at the ends of the working arc: there the contour is only C2. The idle arc of a planar cam, whose
/// radius of curvature varies the most, is divided into `idle_pieces`.
[[nodiscard]] std::vector<core::Range> smooth_pieces(const cam::Cam& cam, int idle_pieces = 1);

[[nodiscard]] gp_Pnt point(const solid::Vec3& p);

/// A band of the lateral surface. Rails are its control points across: it is straight from one to the next
/// (degree 1) or a true arc (degree 2, rational).
struct Strip {
    std::vector<Rail> rails;
    std::vector<double> weights;
    int degree = 1;
};
[[nodiscard]] Strip ruled(Rail low, Rail high);
/// @param rails start and end of each arc with the corner of its tangents between them: 3, 5, 7 ... rails
/// @param half half the angle of each arc [rad]
[[nodiscard]] Strip arcs(std::vector<Rail> rails, double half);

/// A direction psi and the splines' parameter there.
struct Node {
    double psi = 0.0;  ///< [rad]
    double at = 0.0;   ///< [mm], from 0
};
/// The nodes at which the splines of neighbouring strips meet their rails: one set for all, so that neighbours meet in one curve. Their
/// parameter grows half with the rails' length and half with psi. By psi alone a flat piece, and by length alone a sharp bend, would cover
/// a very small range of the parameter, and integrals with a fixed number of points over a face would miss it.
struct Nodes {
    std::vector<Node> nodes;                  ///< rising
    std::vector<Node> middles;                ///< half-way in psi between neighbouring nodes, where the deviation is measured
    double begin_pace = 0.0, end_pace = 0.0;  ///< d at/dpsi at both ends [mm/rad]
};

/// Enough nodes that no spline deviates from its rail by more than `allowed_mm` at their middles; dense where the contour's third
/// derivative jumps.
[[nodiscard]] Nodes nodes_for(const std::vector<Rail>& rails, core::Range psi, double allowed_mm);
/// The cubic spline through the rail at the nodes, with the rail's slopes at its ends.
[[nodiscard]] Handle(Geom_BSplineCurve) spline(const Rail& rail, const Nodes& nodes);
/// Its distance from the rail at the middles.
[[nodiscard]] std::vector<double> deviations_mm(const Rail& rail, const Nodes& nodes);
/// The strip's surface, u across and v along it: the spans of v set the number of points of OpenCASCADE's default integrals.
[[nodiscard]] TopoDS_Face face_of(const Strip& strip, const Nodes& nodes);

/// The lateral faces of a part, groove included, and the two rims at which its flat faces end.
struct Side {
    std::vector<TopoDS_Face> faces;
    TopoDS_Wire lower_rim, upper_rim;  ///< counter-clockwise seen from above
    double z_low_mm = 0.0, z_high_mm = 0.0;
    double lower_lip_mm = 0.0;  ///< z of the lower flange's inner face
    double deviation_mm = 0.0;  ///< of the splines from their rails
};
/// @param idle_pieces number of faces along a planar part's idle arc, in each strip
[[nodiscard]] Side side_of(const solid::Part& part, int idle_pieces);

/// The flat faces, the boss and the bore, which close a part's side.
[[nodiscard]] std::vector<TopoDS_Shape> closing_faces(const Side& side, const solid::HubOptions& hub);
/// Upright, with holes from end to end and true arcs.
[[nodiscard]] TopoDS_Shape prism(const solid::Outline& outline, const std::vector<solid::Outline>& holes, double low_mm, double high_mm);
/// A cutter with true arcs.
[[nodiscard]] TopoDS_Shape prism(const solid::Cutter& cutter);

}  // namespace fusee::exchange::brep
