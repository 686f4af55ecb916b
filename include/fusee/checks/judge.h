#pragma once
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "fusee/checks/rule.h"

/// The means of every rule: declared limits, effective limits and the comparison.
namespace fusee::checks {

/// Declares a limit of a rule: its severity, bound, unit and default. The default is a number, or a text that names the quantity it depends
/// on.
Limit required(core::Bound bound, const char* unit, double value, const char* name = "required");
Limit required(core::Bound bound, const char* unit, const char* by, const char* name = "required");
Limit review(core::Bound bound, const char* unit, double value, const char* name = "review");
Limit review(core::Bound bound, const char* unit, const char* by, const char* name = "review");
/// The same limit, which belongs to the process: a profile's value in its place holds for the profile's own process only.
Limit of_process(Limit limit);
inline constexpr core::Bound kAtLeast = core::Bound::kAtLeast, kAtMost = core::Bound::kAtMost;

/// The limit that applies to one design.
struct EffectiveLimit {
    const Limit* limit = nullptr;
    double normal = 0.0;           ///< the default
    const Override* by = nullptr;  ///< the override in its place; nullptr: none
    [[nodiscard]] double value() const { return by ? by->value : normal; }
};

/// The effective limits of one rule for one design: its own, or the profile's overrides.
class Allowed {
public:
    Allowed(const RuleInfo& rule, std::span<const Override> overrides) : rule_(rule), overrides_(overrides) {}
    /// @param name of a declared limit @param normal its default where the declaration has no number
    [[nodiscard]] EffectiveLimit operator()(std::string_view name, double normal = std::numeric_limits<double>::quiet_NaN()) const;
    /// A limit that the profile may omit (0): nothing then, unless it is overridden.
    [[nodiscard]] std::optional<EffectiveLimit> stated(std::string_view name, double normal) const;

private:
    const RuleInfo& rule_;
    std::span<const Override> overrides_;
};

/// A judged finding without texts. It is compared with the first limit that is broken, else with the last one. A value that misses its
/// limit only by rounding (1e-9 relative) meets it. @pre at least one limit, the most severe first
core::Finding compare(double measured, std::initializer_list<EffectiveLimit> limits);

/// Fills in the common fields of a rule's findings: id, source, and the override with its reason. A pass keeps no suggestion.
/// @param where for findings that name no place
void complete(core::Finding& finding, const RuleInfo& rule, const std::string& where);

/// Three significant digits, rounded so that the number is not below (up) or not above (down) `value`.
std::string up(double value);
std::string down(double value);

}  // namespace fusee::checks
