#include <array>
#include <cassert>
#include <optional>

#include "fusee/checks/check.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"

namespace fusee::checks {

#include "rules_registry.h"

namespace {

struct Group {
    std::string_view id;
    const char* title;
    std::optional<cam::Family> family = {};  ///< of its rules; none: any, but for the rules that name theirs
};
constexpr std::array kGroups = {
    Group{"cable", "the cable and its path", cam::Family::kCable},
    Group{"cam", "arms and swept circle"},
    Group{"groove", "the groove's section", cam::Family::kCable},
    Group{"spring", "the base spring"},
    Group{"structure", "walls, flanges and the anchor"},
    Group{"shaft", "shaft and hub"},
    Group{"roller", "a follower's roller on the rim", cam::Family::kRoller},
    Group{"process", "any process"},
    Group{"fdm", "printing filament"},
    Group{"sla", "printing resin"},
    Group{"sls", "printing powder"},
    Group{"mill", "milling, three or four axes"},
    Group{"mill4", "milling with a fourth axis", cam::Family::kCable},
    Group{"stack", "plates cut by wire or laser, stacked"},
    Group{"assembly", "putting it together"},
    Group{"collision", "conflicts between rope practice and manufacturing practice", cam::Family::kCable},
    Group{"joint", "the joint as a whole"},
    Group{"mesh", "third-party meshes (fusee check)"},
};

void validate(const Design& design) {
    core::require_positive("cable.diameter", design.cable.diameter, "m");
    const spring::BaseSpring& spring = design.spring;
    core::require_positive("spring.rate", spring.rate);
    if (spring.wire_diameter > 0.0 && spring.coil_diameter > 0.0 && spring.coil_diameter <= spring.wire_diameter)
        throw core::InvalidInput("spring.coil_diameter", std::to_string(spring.coil_diameter), "above the wire's diameter [m]");
}

/// Rules of cable and groove do not apply to a roller's rim, and the other way round.
bool suits(const Rule& rule, const Design& design) {
    return !rule.family || (*rule.family == cam::Family::kRoller) == design.part.cam.has_roller();
}

/// The cable that rules measure from. A roller's rim has none: what the rules take for the groove's floor is then the rim itself.
Cable cable_on(const Design& design) {
    Cable cable = design.cable;
    if (design.part.cam.has_roller()) cable.diameter = 0.0;
    return cable;
}

core::Findings run_all(const Design& design, bool has_mesh) {
    validate(design);
    const Cable cable = cable_on(design);
    const Design seen{design.part, design.spring, cable, design.process, design.overrides};
    core::Findings findings;
    for (const Rule& rule : rules())
        if (suits(rule, seen) && (has_mesh || !rule.needs_mesh)) core::append(findings, rule.run(seen));
    return findings;
}

}  // namespace

std::span<const Rule> rules() {
    static const Rules all = [] {
        Rules by_id = make_rules<Rule>(kRegistered), made;
        for (const Group& group : kGroups)
            for (Rule& rule : by_id)
                if (rule.group() == group.id) {
                    if (!rule.family) rule.family = group.family;
                    made.push_back(std::move(rule));
                }
        return made;
    }();
    return all;
}

const Rule* find_rule(std::string_view id) {
    const std::span<const Rule> all = rules();
    return core::find_by(all, &Rule::id, id);
}

const char* group_title(std::string_view group) {
    const Group* found = core::find_by(kGroups, &Group::id, group);
    assert(found != nullptr && "every group of rules has a title");
    return found->title;
}

core::Findings check(const Design& design) { return run_all(design, true); }

core::Findings check_without_mesh(const Design& design) { return run_all(design, false); }

}  // namespace fusee::checks
