#pragma once
#include <string>
#include <vector>

#include "fusee/core/units.h"

namespace fusee::report {

/// About `count` round values in the range, in steps of 1, 2 or 5 times a power of ten.
[[nodiscard]] std::vector<double> round_ticks(const core::Range& range, int count);

/// Name of the axis of many charts.
inline constexpr const char* kCoContractionAxis = "co-contraction, motor torque at the capstan [Nm]";

/// Curves and dots over one axis as an inline SVG; the style sheet sets the colours.
class Plot {
public:
    /// Axis names with unit, e.g. "capstan angle [rad]".
    Plot(std::string title, std::string x_name, std::string y_name);

    /// @param css colour class of the style sheet, e.g. "se"; @param dashed for a second curve of the same quantity. NaN leaves a gap.
    Plot& curve(std::string label, std::vector<double> x, std::vector<double> y, std::string css, bool dashed = false);
    /// Dots; with `deviation`, bars from y - deviation to y + deviation (none for NaN). Classes: se, pe, t, linear, sum.
    Plot& points(std::string label, std::vector<double> x, std::vector<double> y, std::string css, std::vector<double> deviation = {});
    /// The area between two curves, behind everything else and not in the legend.
    Plot& band(std::string label, std::vector<double> x, std::vector<double> low, std::vector<double> high, std::string css);
    /// A band over a range of x with its name.
    Plot& shade(const core::Range& x, std::string label);
    /// A vertical line with its name.
    Plot& mark(double x, std::string label);
    /// Extends the y axis to zero.
    Plot& from_zero();

    [[nodiscard]] std::string svg() const;

private:
    struct Curve {
        std::string label;
        std::vector<double> x, y;
        std::string css;
        bool dashed;
    };
    struct Points {
        std::string label;
        std::vector<double> x, y;
        std::string css;
        std::vector<double> low, high;  // ends of the error bars; y without bars
    };
    struct Band {
        std::string label;
        std::vector<double> x, low, high;
        std::string css;
    };
    struct Key {  // of the legend
        std::string mark, label;
    };
    struct Frame;
    [[nodiscard]] Frame frame() const;
    [[nodiscard]] std::string axes(const Frame& f) const;
    [[nodiscard]] std::string bands(const Frame& f) const;
    [[nodiscard]] std::string curves(const Frame& f) const;
    [[nodiscard]] std::string dots(const Frame& f) const;
    [[nodiscard]] std::string notes(const Frame& f) const;
    [[nodiscard]] std::vector<std::vector<Key>> legend_rows() const;
    [[nodiscard]] std::string legend() const;

    std::string title_, x_name_, y_name_;
    std::vector<Curve> curves_;
    std::vector<Points> points_;
    std::vector<Band> bands_;
    std::vector<std::pair<core::Range, std::string>> shades_;
    std::vector<std::pair<double, std::string>> marks_;
    bool from_zero_ = false;
};

}  // namespace fusee::report
