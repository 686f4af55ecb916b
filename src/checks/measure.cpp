#include "measure.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"

namespace fusee::checks {

namespace {

constexpr double kRounding = 1e-9;

core::Finding compare(double measured, double allowed, core::Bound bound, core::Severity when_broken, const std::string& unit) {
    core::Finding f;
    f.measured = std::abs(measured - allowed) <= kRounding * std::abs(allowed) ? allowed : measured;
    f.allowed = allowed;
    f.bound = bound;
    f.unit = unit;
    return core::judged(std::move(f), when_broken);
}

core::Finding judge(double measured, const Limits& limits, core::Bound bound, const std::string& unit) {
    core::Finding f;
    if (limits.required) f = compare(measured, *limits.required, bound, core::Severity::kRequired, unit);
    if (f.severity == core::Severity::kPass && limits.recommended)
        f = compare(measured, *limits.recommended, bound, core::Severity::kReview, unit);
    return f;
}

std::string three_digits(double value, double (*round)(double), double slack) {
    if (value == 0.0 || !std::isfinite(value)) return fmt::format("{:g}", value);
    const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
    return fmt::format("{:.10g}", round(value / step + slack) * step);
}

}  // namespace

core::Finding at_least(double measured, const Limits& limits, const std::string& unit) {
    return judge(measured, limits, core::Bound::kAtLeast, unit);
}
core::Finding at_most(double measured, const Limits& limits, const std::string& unit) {
    return judge(measured, limits, core::Bound::kAtMost, unit);
}

std::string name(const Design& design) { return cam::to_string(design.part.cam.kind); }

std::string where(const Design& design, double psi) { return fmt::format("{} at psi {:.1f} deg", name(design), core::deg_from_rad(psi)); }

core::Place place(const cam::PathPoint& p, double offset) {
    const double h = p.h + offset, c = std::cos(p.psi), s = std::sin(p.psi);
    return {p.psi, {core::mm_from_m(h * c - p.slope * s), core::mm_from_m(h * s + p.slope * c), core::mm_from_m(p.z)}};
}

std::string up(double value) { return three_digits(value, std::ceil, -kRounding); }
std::string down(double value) { return three_digits(value, std::floor, kRounding); }

}  // namespace fusee::checks
