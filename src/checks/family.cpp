#include "family.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace fusee::checks {

namespace {

constexpr std::string_view kRollerGroup = "roller";

/// What only a cable's part has: groups as a whole, and single rules of the others.
constexpr std::array<std::string_view, 4> kCableGroups{"cable", "groove", "mill4", "collision"};
constexpr std::array<std::string_view, 16> kCableRules{"cam.arm_range",
                                                       "structure.anchor",
                                                       "structure.anchor_floor",
                                                       "structure.flange_bending",
                                                       "structure.flange_slenderness",
                                                       "process.wall",
                                                       "fdm.layers",
                                                       "sla.support",
                                                       "sls.groove",
                                                       "stack.plate",
                                                       "stack.groove_width",
                                                       "stack.hole",
                                                       "stack.dowels",
                                                       "stack.climb",
                                                       "assembly.thread",
                                                       "assembly.anchor_reach"};

template <class List>
bool holds(const List& list, std::string_view id) {
    return std::find(list.begin(), list.end(), id) != list.end();
}

}  // namespace

bool suits(const Rule& rule, const Design& design) {
    if (!design.part.cam.has_roller()) return rule.group() != kRollerGroup;
    return !holds(kCableGroups, rule.group()) && !holds(kCableRules, rule.id);
}

Cable cable_on(const Design& design) {
    Cable cable = design.cable;
    if (design.part.cam.has_roller()) cable.diameter = 0.0;
    return cable;
}

}  // namespace fusee::checks
