#include "fusee/checks/rule.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/lists.h"
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

/// States in the report that the profile sets the limit, and why.
std::string override_text(const core::OverriddenLimit& o) {
    const std::string instead = std::isnan(o.normal) ? "where the rule has none" : "instead of " + with_unit(o.normal, o.unit);
    return fmt::format("; the profile's {} = {} {}: {}", o.limit, with_unit(o.value, o.unit), instead, o.reason);
}

}  // namespace

std::string Limit::key() const { return unit.empty() ? name : name + "_" + in_key(unit); }

std::string Limit::text() const {
    return fmt::format("{} {}", bound == kAtLeast ? "at least" : "at most", std::isnan(value) ? by : with_unit(value, unit));
}

std::string_view RuleInfo::group() const {
    const std::string_view whole = id;
    return whole.substr(0, whole.find('.'));
}

core::Severity RuleInfo::severity() const {
    core::Severity highest = core::Severity::kPass;
    for (const Limit& l : limits) highest = std::max(highest, l.severity);
    return highest;
}

const Limit* RuleInfo::limit(std::string_view key) const { return core::find_by(limits, &Limit::key, key); }

void complete(core::Finding& f, const RuleInfo& rule, const std::string& where) {
    f.rule = rule.id;
    if (f.where.empty()) f.where = where;
    if (f.source.empty()) f.source = rule.source;
    if (f.severity == core::Severity::kPass) f.suggestion.clear();
    for (const core::OverriddenLimit& o : f.overridden) f.what += override_text(o);
}

std::string Need::in_profile(const char* key, const std::string& part) {
    const std::string_view whole = key;
    return whole.starts_with("cable.") ? std::string(whole) : part + "." + key;
}

std::string Need::text(const std::string& part) const {
    std::string others;
    for (const char* other : or_else)
        if (other != nullptr) others += (others.empty() ? "" : " and ") + in_profile(other, part);
    return in_profile(key, part) + (others.empty() ? "" : " (or " + others + ")");
}

namespace {

/// The missing keys, as in the profile; empty: the rule can be judged.
std::string missing(const Rule& rule, const Design& design, const Allowed& allowed) {
    std::string keys;
    for (const Need& need : rule.needs) {
        if (need.stated(design) || (need.limit != nullptr && allowed(need.limit).by != nullptr)) continue;
        keys += (keys.empty() ? "" : " and ") + need.text(name(design));
    }
    return keys;
}

}  // namespace

core::Findings Rule::run(const Design& design) const {
    if (applies != nullptr && !applies(design)) return {};
    const Allowed allowed(*this, design.overrides);
    const std::string lacking = missing(*this, design, allowed);
    core::Findings findings = lacking.empty() ? measure(design, allowed) : core::Findings{core::not_judged(id, title, lacking)};
    for (core::Finding& f : findings) complete(f, *this, name(design));
    return findings;
}

}  // namespace fusee::checks
