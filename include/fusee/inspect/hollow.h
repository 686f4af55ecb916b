#pragma once
#include <cstdint>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::inspect {

class Body;

/// A concave cylinder, or a part of one: a hole, or a rounded inner edge.
struct Hollow {
    solid::Vec3 axis{};       ///< unit
    solid::Vec3 middle_mm{};  ///< on the axis, half way
    double diameter_mm = 0.0;
    double length_mm = 0.0;         ///< along the axis
    double covers = 0.0;            ///< its extent about the axis [rad]
    bool open[2] = {false, false};  ///< at its far end along -axis and along +axis
    std::vector<std::uint32_t> triangles;

    /// It spans more than 200 degrees, unlike the end of a slot, and is longer than one ring of facets.
    [[nodiscard]] bool is_hole() const;
    [[nodiscard]] bool is_through() const { return open[0] && open[1]; }
};

/// Finds facets along one axis that turn by at most 75 degrees from one to the next around empty space, with their corners on one circle.
/// Facets may have any width, so a hole may be a prism of five sides or more. Holes of a mesh whose triangles do not follow the axis
/// (marching cubes) are not found. Sorted by their first triangle. O(triangles). Body::hollows() holds them.
[[nodiscard]] std::vector<Hollow> find_hollows(const Body& body);

}  // namespace fusee::inspect
