#pragma once
#include <array>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::report {

/// Closed polygons in which the plane z = `z_mm` cuts a closed mesh [mm]: what a saw would show of the part as exported.
[[nodiscard]] std::vector<std::vector<std::array<double, 2>>> slice(const solid::Mesh& mesh, double z_mm);

}  // namespace fusee::report
