#include "design/markers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fusee/core/units.h"
#include "page/html.h"

namespace fusee::report {

std::vector<double> spread_angles(std::vector<double> wanted, double least) {
    constexpr double kTurn = 2.0 * core::kPi;
    constexpr int kPasses = 400;  // each pass halves what a pair lacks; 20 markers settle in some dozen passes
    const std::size_t n = wanted.size();
    if (n < 2) return wanted;
    least = std::min(least, 0.999 * kTurn / static_cast<double>(n));
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
    for (int pass = 0; pass < kPasses; ++pass)
        for (std::size_t i = 0; i < n; ++i) {
            double &a = wanted[order[i]], &b = wanted[order[(i + 1) % n]];
            const double lack = least - (b - a + (i + 1 == n ? kTurn : 0.0));
            if (lack <= 0.0) continue;
            a -= 0.5 * lack;
            b += 0.5 * lack;
        }
    return wanted;
}

namespace {

/// A rule that passed has a dot at its place and no disc.
std::string passed_svg(const Marker& m, double size_mm) {
    return fmt::format("<g class=\"place pass\" id=\"place-{}\"><title>{}</title><circle cx=\"{}\" cy=\"{}\" r=\"{}\"/></g>", m.number,
                       escape(m.title), coordinate(m.x_mm), coordinate(-m.y_mm), coordinate(0.28 * size_mm));
}

std::string disc_svg(const Marker& m, double x, double y, double size_mm) {
    return fmt::format(
               "<a class=\"place {}\" href=\"#finding-{}\" id=\"place-{}\" aria-label=\"{}\"><title>{}</title><path class=\"leader\" "
               "d=\"M{} {}L{} {}\"/><circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
               css_of(m.severity), m.number, m.number, escape(m.title), escape(m.title), coordinate(m.x_mm), coordinate(-m.y_mm),
               coordinate(x), coordinate(-y), coordinate(m.x_mm), coordinate(-m.y_mm), coordinate(0.28 * size_mm)) +
           fmt::format(
               "<circle class=\"disc\" cx=\"{}\" cy=\"{}\" r=\"{}\"/><text x=\"{}\" y=\"{}\" font-size=\"{}\" "
               "text-anchor=\"middle\">{}</text></a>",
               coordinate(x), coordinate(-y), coordinate(size_mm), coordinate(x), coordinate(-y + 0.42 * size_mm),
               coordinate(1.2 * size_mm), m.number);
}

}  // namespace

std::string markers_svg(const std::vector<Marker>& markers, const std::array<double, 2>& centre_mm, double radius_mm, double size_mm) {
    std::vector<Marker> shown;
    std::string out;
    for (const Marker& marker : markers)
        if (marker.severity == core::Severity::kPass)
            out += passed_svg(marker, size_mm);
        else
            shown.push_back(marker);
    std::vector<double> angles;
    for (const Marker& marker : shown) angles.push_back(std::atan2(marker.y_mm - centre_mm[1], marker.x_mm - centre_mm[0]));
    angles = spread_angles(angles, 2.3 * size_mm / radius_mm);
    for (std::size_t i = 0; i < shown.size(); ++i)
        out += disc_svg(shown[i], centre_mm[0] + radius_mm * std::cos(angles[i]), centre_mm[1] + radius_mm * std::sin(angles[i]), size_mm);
    return out;
}

}  // namespace fusee::report
