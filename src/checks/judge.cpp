#include "fusee/checks/judge.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace fusee::checks {

namespace {

constexpr double kRounding = 1e-9;

core::Finding compare_one(double measured, const EffectiveLimit& effective) {
    core::Finding f;
    f.allowed = effective.value();
    f.measured = std::abs(measured - f.allowed) <= kRounding * std::abs(f.allowed) ? f.allowed : measured;
    f.bound = effective.limit->bound;
    f.unit = effective.limit->unit;
    return core::judged(std::move(f), effective.limit->severity);
}

std::string three_digits(double value, double (*round)(double), double slack) {
    if (value == 0.0 || !std::isfinite(value)) return fmt::format("{:g}", value);
    const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
    return fmt::format("{:.10g}", round(value / step + slack) * step);
}

constexpr double kByDesign = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Limit required(core::Bound bound, const char* unit, double value, const char* name) {
    return {name, core::Severity::kError, bound, unit, value, ""};
}
Limit required(core::Bound bound, const char* unit, const char* by, const char* name) {
    return {name, core::Severity::kError, bound, unit, kByDesign, by};
}
Limit review(core::Bound bound, const char* unit, double value, const char* name) {
    return {name, core::Severity::kWarning, bound, unit, value, ""};
}
Limit review(core::Bound bound, const char* unit, const char* by, const char* name) {
    return {name, core::Severity::kWarning, bound, unit, kByDesign, by};
}

Limit of_process(Limit limit) {
    limit.of_process = true;
    return limit;
}

EffectiveLimit Allowed::operator()(std::string_view name, double normal) const {
    EffectiveLimit effective;
    for (const Limit& limit : rule_.limits)
        if (limit.name == name) effective.limit = &limit;
    assert(effective.limit && "a rule declares its limits");
    effective.normal = std::isnan(effective.limit->value) ? normal : effective.limit->value;
    for (const Override& o : overrides_)
        if (o.rule == rule_.id && o.limit == effective.limit->key()) effective.by = &o;
    return effective;
}

std::optional<EffectiveLimit> Allowed::stated(std::string_view name, double normal) const {
    const EffectiveLimit effective = (*this)(name, normal > 0.0 ? normal : kByDesign);
    return effective.by || normal > 0.0 ? std::optional(effective) : std::nullopt;
}

core::Finding compare(double measured, std::initializer_list<EffectiveLimit> limits) {
    assert(limits.size() > 0);
    core::Finding f;
    for (const EffectiveLimit& limit : limits)
        if (f.severity == core::Severity::kPass) f = compare_one(measured, limit);
    for (const EffectiveLimit& limit : limits)
        if (limit.by) f.overridden.push_back({limit.by->limit, limit.by->value, limit.normal, limit.limit->unit, limit.by->reason});
    return f;
}

std::string up(double value) { return three_digits(value, std::ceil, -kRounding); }
std::string down(double value) { return three_digits(value, std::floor, kRounding); }

}  // namespace fusee::checks
