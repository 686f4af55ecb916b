#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fusee/core/change.h"

namespace fusee::core {

enum class Severity {
    kPass,       ///< the rule holds; kept so that the margin can be read
    kNotJudged,  ///< the rule applies, but the profile does not state what it needs; `suggestion` names the missing keys
    kWarning,    ///< a person must review and accept it
    kError,      ///< the part or the law cannot be made and must be changed
};

/// The side of `allowed` on which the measured value must be.
enum class Bound { kAtMost, kAtLeast };

/// A place on a part, in its body frame.
struct Place {
    double angle = 0.0;                   ///< psi, direction of the cable normal [rad]
    std::array<double, 3> point_mm = {};  ///< x, y, z [mm]
};

/// A limit that the profile puts in place of the rule's default.
struct OverriddenLimit {
    std::string limit;    ///< as in the profile: "required_mm"
    double value = 0.0;   ///< the profile's
    double normal = 0.0;  ///< the rule's default for this part; NaN: it has none
    std::string unit;     ///< of both
    std::string reason;   ///< the profile's
};

/// Result of a rule or a synthesis step, and what to change. An impossible design is a finding, not an exception.
struct Finding {
    std::string rule;  ///< stable id "group.name", e.g. "cable.bend_ratio"
    Severity severity = Severity::kPass;
    std::string what;  ///< one sentence for a person
    double measured = 0.0;
    Bound bound = Bound::kAtLeast;
    double allowed = 0.0;
    std::string unit;   ///< of measured and allowed, e.g. "mm"; "": none
    std::string where;  ///< part and place in words, e.g. "k_pe at psi 12.0 deg", "law at 0.5 Nm"
    std::optional<Place> place;
    Suggestion suggestion;                         ///< the nearest feasible change, with a number; empty when the rule passes
    std::string source;                            ///< of the limit
    std::vector<OverriddenLimit> overridden = {};  ///< limits of this finding that the profile sets
};
using Findings = std::vector<Finding>;

/// A finding of severity kError: the design cannot be made. The caller adds place, suggestion and source.
[[nodiscard]] Finding error_finding(std::string rule, std::string what, double measured, Bound bound, double allowed, std::string unit);

/// A rule that applies, but cannot be judged. `measured` and `allowed` are NaN.
/// @param missing the keys to state, e.g. "k_se.spring.wire_diameter_mm and k_se.spring.coil_diameter_mm"
[[nodiscard]] Finding not_judged(std::string rule, std::string what, std::string missing);

/// Sets the severity by comparing measured with allowed: `when_broken` if the bound is broken or the value is NaN.
Finding judged(Finding finding, Severity when_broken);

[[nodiscard]] bool any_error(const Findings& findings);
[[nodiscard]] std::size_t count(const Findings& findings, Severity severity);
/// A warning or an error.
[[nodiscard]] bool is_broken(const Finding& finding);
[[nodiscard]] const char* to_string(Severity severity);
/// "error: cable.bend_ratio: <what>: measured 6.1, allowed at least 8 (k_se at psi 3 deg); suggestion". As many digits as it
/// takes to tell measured from allowed. A rule that was not judged: "not judged: spring.stress: <what> (k_se); missing: <keys>"
[[nodiscard]] std::string to_line(const Finding& finding);
void append(Findings& to, const Findings& more);

/// A value, or the findings that say why there is none.
template <class T>
class Outcome {
public:
    Outcome(T value) : state_(std::move(value)) {}                      // NOLINT(google-explicit-constructor)
    Outcome(Findings refusal) : state_(std::move(refusal)) {}           // NOLINT(google-explicit-constructor)
    Outcome(Finding refusal) : state_(Findings{std::move(refusal)}) {}  // NOLINT(google-explicit-constructor)

    [[nodiscard]] explicit operator bool() const { return state_.index() == 0; }
    [[nodiscard]] const T& value() const& { return std::get<0>(state_); }
    [[nodiscard]] T&& value() && { return std::get<0>(std::move(state_)); }
    [[nodiscard]] const T& operator*() const& { return value(); }
    [[nodiscard]] const T* operator->() const { return &value(); }
    [[nodiscard]] const Findings& refusal() const { return std::get<1>(state_); }

private:
    std::variant<T, Findings> state_;
};

}  // namespace fusee::core
