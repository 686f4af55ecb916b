#pragma once
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "fusee/checks/rule.h"

/// What every rule is written with: limits as declared, limits as they hold, and the comparison.
namespace fusee::checks {

/// How a rule declares a limit: what breaking it means, the side, the unit, and its default: a number, or in words what it depends on.
Limit required(core::Bound bound, const char* unit, double value, const char* name = "required");
Limit required(core::Bound bound, const char* unit, const char* by, const char* name = "required");
Limit review(core::Bound bound, const char* unit, double value, const char* name = "review");
Limit review(core::Bound bound, const char* unit, const char* by, const char* name = "review");
inline constexpr core::Bound kAtLeast = core::Bound::kAtLeast, kAtMost = core::Bound::kAtMost;

/// A limit as it holds for one design.
struct EffectiveLimit {
    const Limit* limit = nullptr;
    double normal = 0.0;           ///< the default
    const Override* by = nullptr;  ///< the profile's word in its place
    [[nodiscard]] double value() const { return by ? by->value : normal; }
};

/// The limits of one rule as they hold for one design: its own, or what the profile puts in their place.
class Allowed {
public:
    Allowed(const RuleInfo& rule, std::span<const Override> overrides) : rule_(rule), overrides_(overrides) {}
    /// @param name of a declared limit @param normal its default, where the declaration names none
    [[nodiscard]] EffectiveLimit operator()(std::string_view name, double normal = std::numeric_limits<double>::quiet_NaN()) const;
    /// A limit that the profile may leave open (0): none then, unless it is overridden.
    [[nodiscard]] std::optional<EffectiveLimit> stated(std::string_view name, double normal) const;

private:
    const RuleInfo& rule_;
    std::span<const Override> overrides_;
};

/// A judged finding without words: against the first limit that is broken, else against the last. A value that misses its limit only by
/// rounding (1e-9 relative) is on it. @pre at least one limit, the most severe first
core::Finding judge(double measured, std::initializer_list<EffectiveLimit> limits);

/// Fills in what all findings of a rule have in common: id, source, no suggestion where nothing is wrong, whose limit it is and why.
/// @param where for findings that name no place
void complete(core::Finding& finding, const RuleInfo& rule, const std::string& where);

/// Three significant digits, rounded so that the number is not below (up) or not above (down) `value`.
std::string up(double value);
std::string down(double value);

}  // namespace fusee::checks
