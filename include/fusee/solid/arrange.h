#pragma once
#include <array>
#include <optional>
#include <vector>

namespace fusee::solid {

using Size2 = std::array<double, 2>;  ///< along x and y [mm]

/// Where a rectangle stands: its lower left corner, after it was turned by 90 deg or not.
struct Spot {
    bool turned = false;
    Size2 corner_mm{};
};

/// Places rectangles on a bed from its corner (0, 0), with at least `spacing_mm` between any two. Every order and every choice of quarter
/// turns is tried, fewest turns first; in each the rectangles are set down one after the other as low, then as far left, as they go beside
/// those that stand. Nothing if none fits. Deterministic. @pre at most 6 rectangles
[[nodiscard]] std::optional<std::vector<Spot>> arrange(const std::vector<Size2>& sizes_mm, Size2 bed_mm, double spacing_mm);

/// The least factor by which the bed has to be larger, or may be smaller, for `arrange` to succeed; to 1e-3.
[[nodiscard]] double least_bed(const std::vector<Size2>& sizes_mm, Size2 bed_mm, double spacing_mm);

}  // namespace fusee::solid
