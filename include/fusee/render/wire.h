#pragma once
#include <Eigen/Core>
#include <vector>

#include "fusee/solid/mesh.h"

/// Meshes of wires for pictures: cables and the coils of springs.
namespace fusee::render {

/// A tube of `sides` sides along a line of points [mm], closed at both ends. @pre two points at least, none twice in a row
[[nodiscard]] solid::Mesh tube(const std::vector<Eigen::Vector3d>& line_mm, double radius_mm, int sides = 8);

/// A coil spring about the z axis, from z = 0 to `length_mm` [mm]. @pre lengths and turns above 0
struct Coil {
    double mean_radius_mm = 0.0, wire_mm = 0.0;
    double length_mm = 0.0;  ///< outside to outside
    double turns = 0.0;
    bool left_hand = false;
};
[[nodiscard]] solid::Mesh coil_mesh(const Coil& coil);

}  // namespace fusee::render
