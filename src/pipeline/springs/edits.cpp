#include "fusee/core/units.h"
#include "fusee/pipeline/springs.h"

namespace fusee::pipeline {

std::vector<profile::Edit> spring_edits(cam::PartKind part, const FoundSpring& found, const profile::Profile& profile) {
    const bool torsion = part == cam::PartKind::kSeries;
    const spring::BaseSpring& s = found.spring;
    const std::string t = profile.table_of(part) + ".spring.";
    const std::string why = found.bought ? "bought: " + found.name : "wound: " + found.name;
    std::vector<profile::Edit> edits;
    const auto set = [&](const char* leaf, double value) { edits.push_back(profile::number_edit(profile, t + leaf, value, "")); };
    edits.push_back(profile::number_edit(profile, t + (torsion ? "rate_Nm_per_rad" : "rate_N_per_m"), s.rate, why));
    set(torsion ? "preload_rad" : "preload_mm", s.preload);
    set(torsion ? "max_angle_rad" : "max_travel_mm", s.max_state);
    set(torsion ? "max_torque_Nm" : "max_force_N", s.max_load);
    set("wire_mm", s.wire_diameter);
    set("coil_mm", s.coil_diameter);
    set("active_coils", s.active_coils);
    set("free_length_mm", s.free_length);
    set("tensile_strength_MPa", s.tensile_strength);
    edits.push_back(profile::text_edit(profile, t + "wire_class", spring::kWireClassNames.at(static_cast<std::size_t>(s.wire_class)), ""));
    if (torsion) edits.push_back(profile::text_edit(profile, t + "hand", s.hand == spring::Hand::kLeft ? "left" : "right", ""));
    set("rod_mm", s.rod_diameter);
    set("cycles", s.cycles);
    return edits;
}

}  // namespace fusee::pipeline
