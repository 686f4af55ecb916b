#include "policy.h"

#include <algorithm>
#include <string>

#include "judge.h"

namespace fusee::search::fix {

namespace {

// Drawn features weigh least, then adjusted values, then bought parts; the law, the purpose of the design, weighs most.
// docs/guides/fix.md shows this table. The first matching row holds.
constexpr Policy kPolicies[] = {
    {"tolerances.", 0.5, "the drawing"},
    {"process.layer_mm", 0.5, "the slicer"},
    {"groove.", 1.0, "the drawing"},
    {"hub.kind", 2.0, "the drawing"},
    {"hub.bore_mm", 5.0, "another shaft"},
    {"hub.screw_mm", 1.0, "another screw"},
    {"hub.", 1.0, "the drawing"},
    {"features.", 1.0, "the drawing"},
    {"flange_height_mm", 1.0, "the drawing"},
    {"machining.", 1.0, "the programs"},
    {"path.kind", 3.0, "the drawing"},
    {"path.", 1.5, "the drawing"},
    {"guide.", 2.0, "the frame"},
    {"roller.", 2.0, "the drawing"},
    {"spring.preload_rad", 3.0, "the spring's preload", true},
    {"spring.preload_mm", 3.0, "the spring's preload", true},
    {"spring.rate_Nm_per_rad", 5.0, "another spring", true},
    {"spring.rate_N_per_m", 5.0, "another spring", true},
    {"spring.active_coils", 6.0, "another spring", true},
    {"spring.", 6.0, "another spring"},
    {"cable.", 6.0, "another cable"},
    {"process.cutter_radius_mm", 7.0, "another tool"},
    {"law.lead_in_deg", 4.0, "the law", true},
    {"law.start_torque_Nm", 10.0, "the law", true},
    {"law.end_torque_Nm", 10.0, "the law", true},
    {"law.c_Nm", 12.0, "the law", true},
};

}  // namespace

const Policy* policy_of(std::string_view key) {
    if (const std::string part = part_of(std::string(key)); !part.empty()) key.remove_prefix(part.size() + 1);
    const auto fits = [key](const Policy& p) { return p.key.ends_with('.') ? key.starts_with(p.key) : key == p.key; };
    const auto policy = std::find_if(std::begin(kPolicies), std::end(kPolicies), fits);
    return policy == std::end(kPolicies) ? nullptr : &*policy;
}

}  // namespace fusee::search::fix
