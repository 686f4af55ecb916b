#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace fusee::core {

enum class Severity {
    kPass,       ///< the rule holds; kept so that the margin can be read
    kNotJudged,  ///< the rule applies, but the profile does not state what it needs; `suggestion` names the missing keys
    kWarning,    ///< a person must look and accept
    kError,      ///< the part or the law cannot be made as it is
};

/// Which side of `allowed` the measured value has to be on.
enum class Bound { kAtMost, kAtLeast };

/// A place on a part, in its body frame.
struct Place {
    double angle = 0.0;                   ///< psi, direction of the cable normal [rad]
    std::array<double, 3> point_mm = {};  ///< x, y, z [mm]
};

/// A limit that the profile puts in the place of its rule's own.
struct OverriddenLimit {
    std::string limit;    ///< as the profile spells it: "required_mm"
    double value = 0.0;   ///< the profile's
    double normal = 0.0;  ///< the rule's default for this part; NaN: it has none
    std::string unit;     ///< of both
    std::string reason;   ///< the profile's
};

/// What a rule or a synthesis step measured, and what to change. An impossible design is a finding, not an exception.
struct Finding {
    std::string rule;  ///< stable id "group.name", e.g. "cable.bend_ratio"
    Severity severity = Severity::kPass;
    std::string what;  ///< one sentence that a person understands
    double measured = 0.0;
    Bound bound = Bound::kAtLeast;
    double allowed = 0.0;
    std::string unit;   ///< of measured and allowed, e.g. "mm"; "" when they have none
    std::string where;  ///< part and place in words, e.g. "k_pe at psi 12.0 deg", "law at 0.5 Nm"
    std::optional<Place> place;
    std::string suggestion;                        ///< the nearest feasible change, with a number; empty when the rule passes
    std::string source;                            ///< where the limit comes from
    std::vector<OverriddenLimit> overridden = {};  ///< the limits of this finding that are the profile's, not the rule's
};
using Findings = std::vector<Finding>;

/// What forbids a design: a finding of severity kError. Place, suggestion and source are for the caller to add.
[[nodiscard]] Finding error_finding(std::string rule, std::string what, double measured, Bound bound, double allowed, std::string unit);

/// A rule that applies and cannot be judged. `measured` and `allowed` are NaN.
/// @param missing the keys to state, e.g. "k_se.spring.wire_diameter_mm and k_se.spring.coil_diameter_mm"
[[nodiscard]] Finding not_judged(std::string rule, std::string what, std::string missing);

/// Sets the severity by comparing measured with allowed: `when_broken` if the bound is broken or the value is NaN.
Finding judged(Finding finding, Severity when_broken);

[[nodiscard]] bool any_error(const Findings& findings);
[[nodiscard]] std::size_t count(const Findings& findings, Severity severity);
/// Neither a pass nor without a judgement: something that a person has to act on.
[[nodiscard]] bool is_broken(const Finding& finding);
[[nodiscard]] const char* to_string(Severity severity);
/// "required change: cable.bend_ratio: <what>: measured 6.1, allowed at least 8 (k_se at psi 3 deg); suggestion". As many digits as it
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
