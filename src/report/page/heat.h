#pragma once
#include <array>
#include <cstddef>
#include <string>

/// Colour scales in steps, from light to dark in one hue: their order survives grey print and colour-blind eyes.
namespace fusee::report {

inline constexpr std::size_t kHeatLevels = 8;

/// Level i holds bounds[i - 1] <= value < bounds[i].
struct HeatScale {
    std::array<double, kHeatLevels - 1> bounds;
    std::array<const char*, kHeatLevels> fills;  ///< "#rrggbb"
    std::string name;                            ///< of the quantity, with its unit
    [[nodiscard]] std::size_t level(double value) const;
    /// Colour of figures on a level: dark on light, white on dark levels.
    [[nodiscard]] static const char* ink(std::size_t level);
};

[[nodiscard]] const HeatScale& gap_scale();         ///< a gap [sigma]
[[nodiscard]] const HeatScale& similarity_scale();  ///< signature similarity [%]

struct Box {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};
/// A cell with its figure in the middle, SVG; an empty frame with a dash for NaN. @param marked drawn with a strong outline
[[nodiscard]] std::string heat_cell(const Box& box, double value, const std::string& text, const HeatScale& scale, bool marked = false);
/// Every level with its bounds, as a separate figure.
[[nodiscard]] std::string heat_legend(const HeatScale& scale);

}  // namespace fusee::report
