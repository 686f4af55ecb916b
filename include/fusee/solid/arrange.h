#pragma once
#include <array>
#include <optional>
#include <vector>

namespace fusee::solid {

using Size2 = std::array<double, 2>;  ///< along x and y [mm]

/// The place of a rectangle: its lower left corner, and whether it is turned by 90 deg.
struct Spot {
    bool turned = false;
    Size2 corner_mm{};
};

/// Places rectangles on a bed from its corner (0, 0), with at least `spacing_mm` between any two. Evaluates every order and every choice of
/// quarter turns, fewest turns first. Each rectangle is placed as low as possible, then as far left as possible. Nothing if no arrangement
/// fits. Deterministic. @pre at most 6 rectangles
[[nodiscard]] std::optional<std::vector<Spot>> arrange(const std::vector<Size2>& sizes_mm, Size2 bed_mm, double spacing_mm);

/// The least scale factor of the bed with which `arrange` succeeds; to 1e-3.
[[nodiscard]] double least_bed(const std::vector<Size2>& sizes_mm, Size2 bed_mm, double spacing_mm);

}  // namespace fusee::solid
