#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"

/// The holes, slots and marks of a part, and the Boolean that cuts them.
namespace fusee::solid {

/// A prism that is cut from a part: a convex outline over a height range along z or (radial) along +x.
struct Cutter {
    std::string name;     ///< "anchor", "leg_slot", "dowel", "mark", "set_screw"
    Outline outline;      ///< radial: (y, z) of the section
    double low_mm = 0.0;  ///< z, or x for a radial cutter
    double high_mm = 0.0;
    bool radial = false;
    [[nodiscard]] Mesh mesh(double tolerance_mm) const;
};

/// Does the anchor's hole end in the lower face? At the lower end of a helix, whose other turns are above it, beside the boss of an
/// overhung part, which leaves room for the knot. All others end in the top face.
[[nodiscard]] bool anchor_leads_down(const cam::Cam& cam, const PartOptions& options);
/// The anchor's hole and the leg's slot, as far as they end in the top face.
[[nodiscard]] std::vector<Cutter> top_holes(const Part& part);
/// The holes, slots and marks of a part, in the order of the cuts; of plates their dowels' holes, too. @pre its columns are placed
[[nodiscard]] std::vector<Cutter> make_cutters(const Part& part);

/// Between a pin and any other surface [mm]: the least wall of milled metal (docs/rules.md).
inline constexpr double kPinWall_mm = 0.8;
/// The places, in steps, at which a pin along the axis keeps that wall from groove floor, bore, key, slot and anchor hole.
/// @pre a planar part for a cable
[[nodiscard]] std::vector<Point2> free_for_pin(const Part& part, double pin_mm, double beside_bore_mm = 0.0);
/// @returns null of none
[[nodiscard]] const Point2* farthest_from(const Point2& from, const std::vector<Point2>& places);
/// Two such places for the dowels of half plates, as far apart as possible. None: there are no two, or no half plates, as of a helix and
/// of a roller's cam; or pin_mm is 0.
[[nodiscard]] std::vector<Point2> pin_places(const Part& part, double pin_mm);

/// Body angle of the timing mark: 0, or pi where the anchor hole leaves less than 0.8 mm beside a mark at 0 and there is room opposite.
/// @pre the part's columns are placed
[[nodiscard]] double mark_angle(const Part& part);

/// Body minus every tool, by CGAL's corefinement on exact points (plain doubles fail on helical grooves) of the triangles near each tool,
/// or of the whole body where these do not decide. Slivers from rounding back to doubles are removed (without_slivers). Empty at the first
/// cut that CGAL refuses: the result of a failed Boolean is never used.
/// @pre body and tools are closed, oriented and free of self-intersections
[[nodiscard]] std::optional<Mesh> cut(const Mesh& body, const std::vector<Mesh>& tools);

}  // namespace fusee::solid
