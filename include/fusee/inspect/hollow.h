#pragma once
#include <vector>

#include "fusee/inspect/body.h"

namespace fusee::inspect {

/// A concave cylinder, or a part of one: a hole, or a rounded inner edge.
struct Hollow {
    solid::Vec3 axis{};       ///< unit
    solid::Vec3 middle_mm{};  ///< on the axis, half way
    double diameter_mm = 0.0;
    double length_mm = 0.0;         ///< along the axis
    double covers = 0.0;            ///< angle about the axis [rad]
    bool open[2] = {false, false};  ///< at its far end along -axis and along +axis
    std::vector<std::uint32_t> triangles;

    /// More than 200 degrees of it are there, so the end of a slot is none, and it is no mere ring of facets.
    [[nodiscard]] bool is_hole() const;
    [[nodiscard]] bool is_through() const { return open[0] && open[1]; }
};

/// Facets that run along one axis, turn by at most 75 degrees from one to the next with the room inside, and have their corners on one
/// circle. Facets of any width are found, so a hole may be a prism of five sides or more; a mesh whose triangles ignore the axis (marching
/// cubes) hides its holes. By their first triangle. O(triangles).
[[nodiscard]] std::vector<Hollow> find_hollows(const Body& body);

}  // namespace fusee::inspect
