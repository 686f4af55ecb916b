#include "fusee/checks/rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measure.h"

namespace fusee::checks {

namespace {

/// The unit as the end of a key: letters, digits and underlines only.
std::string in_key(const std::string& unit) {
    if (unit == "%") return "percent";
    std::string out = unit;
    std::erase(out, '^');
    std::replace(out.begin(), out.end(), ' ', '_');
    return out;
}

std::string with_unit(double value, const std::string& unit) { return fmt::format("{:g}{}{}", value, unit.empty() ? "" : " ", unit); }

/// A reader of the report sees whose limit it is, and why.
std::string said(const core::OverriddenLimit& o) {
    const std::string instead = std::isnan(o.normal) ? "where the rule has none" : "instead of " + with_unit(o.normal, o.unit);
    return fmt::format("; the profile's {} = {} {}: {}", o.limit, with_unit(o.value, o.unit), instead, o.reason);
}

}  // namespace

std::string Limit::key() const { return unit.empty() ? name : name + "_" + in_key(unit); }

std::string Limit::text() const {
    return fmt::format("{} {}", bound == kAtLeast ? "at least" : "at most", std::isnan(value) ? by : with_unit(value, unit));
}

std::string_view Card::group() const {
    const std::string_view whole = id;
    return whole.substr(0, whole.find('.'));
}

core::Severity Card::severity() const {
    core::Severity gravest = core::Severity::kPass;
    for (const Limit& l : limits) gravest = std::max(gravest, l.severity);
    return gravest;
}

const Limit* Card::limit(std::string_view key) const {
    const auto found = std::find_if(limits.begin(), limits.end(), [key](const Limit& l) { return l.key() == key; });
    return found == limits.end() ? nullptr : &*found;
}

void complete(core::Finding& f, const Card& rule, const std::string& where) {
    f.rule = rule.id;
    if (f.where.empty()) f.where = where;
    if (f.source.empty()) f.source = rule.source;
    if (f.severity == core::Severity::kPass) f.suggestion.clear();
    for (const core::OverriddenLimit& o : f.overridden) f.what += said(o);
}

core::Findings Rule::run(const Design& design) const {
    core::Findings findings = measure(design, Allowed(*this, design.overrides));
    for (core::Finding& f : findings) complete(f, *this, name(design));
    return findings;
}

}  // namespace fusee::checks
