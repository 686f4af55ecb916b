#pragma once
#include <functional>
#include <string>
#include <vector>

#include "fusee/drawing/sheet.h"

namespace fusee::drawing {

/// Leads from millimetres of the part, second axis upwards, to the sheet.
struct View {
    Point origin{};  ///< place of (0, 0)
    double scale = 1.0;
    [[nodiscard]] Point at(double x, double y) const { return {origin[0] + scale * x, origin[1] - scale * y}; }
    [[nodiscard]] Point at(const Point& p) const { return at(p[0], p[1]); }
    [[nodiscard]] Line at(const Line& line) const;
    [[nodiscard]] std::vector<Line> at(const std::vector<Line>& lines) const;
};

/// The largest scale of ISO 5455 that fits; the smallest, 1:100, if none fits.
[[nodiscard]] double largest_scale(const std::function<bool(double)>& fits);
/// "2:1", "1:5"
[[nodiscard]] std::string scale_text(double scale);
/// Box around all points. @pre at least one
[[nodiscard]] Box extent(const std::vector<Line>& lines);
/// The number with at most `digits` decimals, without trailing zeros.
[[nodiscard]] std::string decimals(double value, int digits = 3);

}  // namespace fusee::drawing
