#pragma once
#include <array>
#include <string>
#include <vector>

#include "fusee/core/units.h"
#include "picture/standalone.h"

/// The colours of a gap [sigma] in steps, from light to dark in one hue, as web/src/kit/heat.js has them.
namespace fusee::report {

/// About `count` round values in the range, in steps of 1, 2 or 5 times a power of ten.
[[nodiscard]] std::vector<double> round_ticks(const core::Range& range, int count);

/// Name of the axis of many charts.
inline constexpr const char* kCoContractionAxis = "co-contraction, motor torque at the capstan [Nm]";

/// Curves over one axis as a picture for papers; the style sheet sets the colours. The pages draw theirs by web/src/kit/plot.js.
class Plot {
public:
    /// Axis names with unit, e.g. "capstan angle [rad]".
    Plot(std::string title, std::string x_name, std::string y_name);

    /// @param css colour class of the style sheet, e.g. "se"; @param dashed for a second curve of the same quantity. NaN leaves a gap.
    Plot& curve(std::string label, std::vector<double> x, std::vector<double> y, std::string css, bool dashed = false);
    /// A band over a range of x with its name.
    Plot& shade(const core::Range& x, std::string label);
    /// Extends the y axis to zero.
    Plot& from_zero();

    [[nodiscard]] Figure figure() const;

private:
    struct Curve {
        std::string label;
        std::vector<double> x, y;
        std::string css;
        bool dashed;
    };
    struct Key {  // of the legend
        std::string mark, label;
    };
    struct Frame;
    [[nodiscard]] Frame frame() const;
    [[nodiscard]] std::string axes(const Frame& f) const;
    [[nodiscard]] std::string curves(const Frame& f) const;
    [[nodiscard]] std::string notes(const Frame& f) const;
    [[nodiscard]] std::vector<std::vector<Key>> legend_rows() const;
    [[nodiscard]] std::string legend() const;

    std::string title_, x_name_, y_name_;
    std::vector<Curve> curves_;
    std::vector<std::pair<core::Range, std::string>> shades_;
    bool from_zero_ = false;
};

inline constexpr std::array<double, 7> kGapBounds{1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0};
/// Level i holds bound i - 1 <= gap < bound i. ColorBrewer's YlOrBr in 8 classes, marked "colour-blind safe" (colorbrewer2.org).
inline constexpr std::array<const char*, 8> kGapFills{"#ffffe5", "#fff7bc", "#fee391", "#fec44f",
                                                      "#fe9929", "#ec7014", "#cc4c02", "#8c2d04"};

struct Box {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};
/// A cell with its figure in the middle, SVG; an empty frame with a dash for NaN.
[[nodiscard]] std::string heat_cell(const Box& box, double gap, const std::string& text);
/// Every level with its bounds.
[[nodiscard]] Figure gap_legend();

}  // namespace fusee::report
