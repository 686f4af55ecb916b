#pragma once
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/cam/roller.h"
#include "fusee/core/finding.h"

namespace fusee::checks {

struct Design;
class Allowed;

/// A limit as its rule declares it, in the unit that a shop uses. It names itself by what it is for and by its unit, as keys of a profile
/// do.
struct Limit {
    std::string name;         ///< "required", "review", or more exactly "slot_review"
    core::Severity severity;  ///< of breaking it
    core::Bound bound;        ///< the side on which the measured value has to be
    std::string unit;         ///< "mm", "deg", "%", "d" (cable diameters), ...; "" = a bare number
    double value;             ///< the default; NaN where it depends on the design
    std::string by;           ///< NaN: on what, e.g. "the process's wall"

    [[nodiscard]] std::string key() const;   ///< "required_mm", "review_percent"
    [[nodiscard]] std::string text() const;  ///< "at least 0.8 mm", "at most what the guide leaves"
};

/// What the profile puts in the place of one limit (docs/profile.md).
struct Override {
    std::string rule;    ///< id
    std::string limit;   ///< Limit::key
    double value = 0.0;  ///< in the limit's unit; finite
    std::string reason;  ///< for whoever reads the report
};

/// What the list of rules shows of one, whatever it looks at.
struct RuleInfo {
    const char* id;             ///< "group.name"
    const char* title;          ///< what it guards against
    const char* measures;       ///< what it measures, and where
    const char* source;         ///< of the default limits
    std::vector<Limit> limits;  ///< all that it holds something against

    [[nodiscard]] std::string_view group() const;                  ///< the id before its point
    [[nodiscard]] core::Severity severity() const;                 ///< the most severe that it can find
    [[nodiscard]] const Limit* limit(std::string_view key) const;  ///< nullptr if it has no such limit
};
/// The Markdown tables of docs/rules.md, one for each group in turn.
/// @param needs of each info: the keys that it is not judged without, as Markdown; empty: none needs any
[[nodiscard]] std::string reference(const std::vector<const RuleInfo*>& infos, const std::vector<std::string>& needs = {});

/// A value that a profile may leave open and that a rule cannot judge without.
struct Need {
    const char* key;                          ///< of a part: "spring.wire_mm"; of the profile: "cable.breaking_load_N"
    bool (*stated)(const Design&);            ///< does the profile state it, or not need to?
    const char* limit = nullptr;              ///< an override of this limit states it too: its Limit::name
    std::array<const char*, 3> or_else = {};  ///< keys that together do as well; nullptr ends them

    /// "k_se.spring.wire_mm", "cable.breaking_load_N"
    [[nodiscard]] static std::string in_profile(const char* key, const std::string& part);
    /// All keys as the profile spells them: "k_pe.spring.max_travel_mm (or ... and ...)".
    [[nodiscard]] std::string text(const std::string& part) const;
};

/// One rule: pure, one file under src/checks, returns a finding for what it measured (passes too), none where it does not apply, and one
/// that says so where it could not be judged.
struct Rule : RuleInfo {
    using Measure = std::function<core::Findings(const Design&, const Allowed&)>;

    Measure measure;                           ///< findings without what all have in common: id, part, source
    bool needs_mesh = false;                   ///< looks at the solid, not only at cam, options and springs
    std::vector<Need> needs = {};              ///< without one of them the rule is not judged
    bool (*applies)(const Design&) = nullptr;  ///< to which designs; nullptr: `measure` sees to it, or to all
    std::optional<cam::Family> family = {};    ///< of the parts that it is about; none: that of its group

    /// The rule on one part, with the design's overrides in place of its own limits. Where it applies and the profile leaves open what it
    /// needs: one finding that was not judged and names the missing keys.
    [[nodiscard]] core::Findings run(const Design& design) const;
};

}  // namespace fusee::checks
