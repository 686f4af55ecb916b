#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/core/finding.h"

namespace fusee::checks {

struct Design;
class Allowed;

/// A limit as its rule declares it, in workshop units. Its key is its name with its unit, like the keys of a profile.
struct Limit {
    std::string name;         ///< "required", "review", or more specific: "slot_review"
    core::Severity severity;  ///< of breaking it
    core::Bound bound;        ///< the side on which the measured value must be
    std::string unit;         ///< "mm", "deg", "%", "d" (cable diameters), ...; "" = a bare number
    double value;             ///< the default; NaN where it depends on the design
    std::string by;           ///< if value is NaN: the quantity that it depends on, e.g. "the process's wall"
    bool of_process = false;  ///< a profile's value in its place holds for the profile's own process only

    [[nodiscard]] std::string key() const;   ///< "required_mm", "review_percent"
    [[nodiscard]] std::string text() const;  ///< "at least 0.8 mm", "at least the process's wall"
};

/// A limit of the profile that replaces one of a rule (docs/profile.md).
struct Override {
    std::string rule;    ///< id
    std::string limit;   ///< Limit::key
    double value = 0.0;  ///< in the limit's unit; finite
    std::string reason;  ///< for the reader of the report
};

/// The entry of one rule in the list of rules: rules for designs and for meshes have the same fields.
struct RuleInfo {
    const char* id;             ///< "group.name"
    const char* title;          ///< the fault that it finds
    const char* measures;       ///< the measured quantity and its place
    const char* source;         ///< of the default limits
    std::vector<Limit> limits;  ///< all that it applies

    [[nodiscard]] std::string_view group() const;                  ///< the id up to its dot
    [[nodiscard]] core::Severity severity() const;                 ///< the highest that it can report
    [[nodiscard]] const Limit* limit(std::string_view key) const;  ///< nullptr if it has no such limit
};
/// The Markdown tables of `fusee rules --markdown`, one for each group in turn.
/// @param needs of each info: the keys that it needs, as Markdown; empty: no rule needs any
[[nodiscard]] std::string reference(const std::vector<const RuleInfo*>& infos, const std::vector<std::string>& needs = {});

/// A value that a profile may omit and that a rule needs.
struct Need {
    const char* key;                          ///< of a part: "spring.wire_mm"; of the profile: "cable.breaking_load_N"
    bool (*stated)(const Design&);            ///< true where the profile states it, or does not need to
    const char* limit = nullptr;              ///< name of the limit whose override replaces the value
    std::array<const char*, 3> or_else = {};  ///< keys that together replace it; nullptr ends the list

    /// "k_se.spring.wire_mm", "cable.breaking_load_N"
    [[nodiscard]] static std::string in_profile(const char* key, const std::string& part);
    /// All keys as in the profile: "k_pe.spring.max_travel_mm (or ... and ...)".
    [[nodiscard]] std::string text(const std::string& part) const;
};

/// One rule: a pure function, in a file of src/checks/rules. It returns one finding for each measured value (passes too), none where it
/// does not apply, and a finding "not judged" where data are missing.
struct Rule : RuleInfo {
    using Measure = std::function<core::Findings(const Design&, const Allowed&)>;

    Measure measure;                           ///< findings without the common fields: id, part, source
    bool (*applies)(const Design&) = nullptr;  ///< does it apply to this design? nullptr: `measure` decides, or it always applies
    std::vector<Need> needs = {};              ///< without one of them the rule is not judged
    bool needs_mesh = false;                   ///< uses the solid, not only cam, options and springs
    std::optional<cam::Family> family = {};    ///< of the parts that it is about; none: that of its group

    /// Applies the rule to one part, with the design's overrides in place of its own limits. If it applies and the profile omits a needed
    /// value: one finding "not judged" that names the missing keys.
    [[nodiscard]] core::Findings run(const Design& design) const;
};
using Rules = std::vector<Rule>;

/// The rules of a registry of files (cmake/FuseeRegistry.cmake), by id.
template <class AnyRule, class Registered, std::size_t N>
[[nodiscard]] std::vector<AnyRule> make_rules(const Registered (&files)[N]) {
    std::vector<AnyRule> made;
    for (const Registered& file : files)
        for (AnyRule& rule : file.make()) made.push_back(std::move(rule));
    std::sort(made.begin(), made.end(), [](const AnyRule& a, const AnyRule& b) { return std::string_view(a.id) < b.id; });
    return made;
}
template <class AnyRule>
[[nodiscard]] std::vector<const RuleInfo*> infos_of(std::span<const AnyRule> rules) {
    std::vector<const RuleInfo*> all;
    for (const AnyRule& rule : rules) all.push_back(&rule);
    return all;
}

}  // namespace fusee::checks
