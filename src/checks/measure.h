#pragma once
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>

#include "fusee/checks/check.h"

namespace fusee::checks {

/// How a rule declares a limit: what breaking it means, the side, the unit, and its default: a number, or in words what it depends on.
Limit required(core::Bound bound, const char* unit, double value, const char* name = "required");
Limit required(core::Bound bound, const char* unit, const char* by, const char* name = "required");
Limit review(core::Bound bound, const char* unit, double value, const char* name = "review");
Limit review(core::Bound bound, const char* unit, const char* by, const char* name = "review");
inline constexpr core::Bound kAtLeast = core::Bound::kAtLeast, kAtMost = core::Bound::kAtMost;

/// A limit as it holds for one design.
struct Bar {
    const Limit* limit = nullptr;
    double normal = 0.0;           ///< the default
    const Override* by = nullptr;  ///< the profile's word in its place
    [[nodiscard]] double value() const { return by ? by->value : normal; }
};

/// The limits of one rule as they hold for one design: its own, or what the profile puts in their place.
class Allowed {
public:
    Allowed(const Rule& rule, const Design& design) : rule_(rule), design_(design) {}
    /// @param name of a declared limit @param normal its default, where the declaration names none
    [[nodiscard]] Bar operator()(std::string_view name, double normal = std::numeric_limits<double>::quiet_NaN()) const;
    /// A limit that the profile may leave open (0): none then, unless it is overridden.
    [[nodiscard]] std::optional<Bar> stated(std::string_view name, double normal) const;

private:
    const Rule& rule_;
    const Design& design_;
};

/// A judged finding without words: against the first bar that is broken, else against the last. A value that misses its limit only by
/// rounding (1e-9 relative) is on it. @pre at least one bar
core::Finding judge(double measured, std::initializer_list<Bar> bars);

bool is_milled(const Design& design);   ///< on three or four axes
bool is_stacked(const Design& design);  ///< from plates cut by wire or laser

/// "k_pe"
std::string name(const Design& design);
/// "k_pe at psi 12.0 deg"
std::string where(const Design& design, double psi);
/// @param offset from the cable's centreline along n [m]; -d/2 is the groove's floor
core::Place place(const cam::PathPoint& point, double offset);

/// Three significant digits, rounded so that the number is not below (up) or not above (down) `value`.
std::string up(double value);
std::string down(double value);

}  // namespace fusee::checks
