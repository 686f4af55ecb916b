#pragma once
#include <array>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/solid/mesh.h"

/// Lines that a drawing shows of a part, in its body frame.
namespace fusee::solid {

/// Closed polygons in which the plane z = `z_mm` cuts a closed mesh [mm]: a cut through the part as exported.
[[nodiscard]] std::vector<std::vector<std::array<double, 2>>> slice(const Mesh& mesh, double z_mm);

/// The pitch curve's parallel at `offset` [m] over `psi`, 720 points a turn and both ends [mm]; seen from +z for a helix.
[[nodiscard]] std::vector<std::array<double, 2>> parallel(const cam::Cam& cam, const core::Range& psi, double offset);

}  // namespace fusee::solid
