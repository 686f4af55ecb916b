#include <fmt/format.h>

#include "fusee/checks/check.h"
#include "measure.h"

namespace fusee::assembly {

#include "rules_registry.h"

std::span<const Rule> rules() {
    static const Rules all = checks::make_rules<Rule>(kRegistered);
    return all;
}

core::Findings check(const Assembly& assembly, std::span<const checks::Override> overrides) {
    core::Findings all;
    for (const Rule& rule : rules())
        for (core::Finding& finding : rule.measure(assembly, Allowed(rule, overrides))) {
            checks::complete(finding, rule, "joint");
            all.push_back(std::move(finding));
        }
    core::append(all, assembly.notes);
    return all;
}

std::string place_text(const Pose& pose) {
    return fmt::format("capstans at {:.0f} and {:.0f} deg, cables paid out by {:.1f} and {:.1f} mm", core::deg_from_rad(pose.agonist.turn),
                       core::deg_from_rad(pose.antagonist.turn), pose.agonist.payout_mm, pose.antagonist.payout_mm);
}

}  // namespace fusee::assembly
