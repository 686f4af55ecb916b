#include "data/figures.h"

#include <fmt/format.h>

#include <cmath>

namespace fusee::report {

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "\u2013";
    const double size = std::abs(value);
    if (size >= std::pow(10.0, digits) && size < 1e9) return fmt::format("{:.0f}", value);  // 40760, not 4.076e+04
    return fmt::format("{:.{}g}", value, digits);
}

std::string deg(double rad, int digits) { return number(deg_from_rad(rad), digits); }
std::string newton_metres(double torque, int digits) { return number(torque, digits) + " Nm"; }

std::string span(const core::Range& range, int digits) {
    if (!std::isfinite(range.low) || !std::isfinite(range.high)) return number(NAN);
    return number(range.low, digits) + " to " + number(range.high, digits);
}

std::string change(double before, double after) { return number(before, 3) + " \u2192 " + number(after, 3); }

std::string percent(double share) { return std::isfinite(share) ? fmt::format("{:.0f} %", 100.0 * share) : number(share); }

}  // namespace fusee::report
