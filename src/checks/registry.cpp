#include <array>

#include "fusee/core/error.h"
#include "measure.h"
#include "rules.h"

namespace fusee::checks {

namespace {

/// Adds what every finding of a rule has in common.
Rule stamped(Rule rule) {
    rule.run = [id = rule.id, source = rule.source, run = std::move(rule.run)](const Design& design) {
        core::Findings findings = run(design);
        for (core::Finding& f : findings) {
            f.rule = id;
            if (f.where.empty()) f.where = name(design);
            if (f.source.empty()) f.source = source;
            if (f.severity == core::Severity::kPass) f.suggestion.clear();
        }
        return findings;
    };
    return rule;
}

void validate(const Design& design) {
    core::require_positive("cable.diameter", design.cable.diameter, "m");
    const spring::BaseSpring& spring = design.spring;
    core::require_positive("spring.rate", spring.rate);
    if (spring.wire_diameter > 0.0 && spring.coil_diameter > 0.0 && spring.coil_diameter <= spring.wire_diameter)
        throw core::InvalidInput("spring.coil_diameter", std::to_string(spring.coil_diameter), "above the wire's diameter [m]");
}

}  // namespace

std::span<const Rule> rules() {
    static const std::array all = {
        stamped(cable_bend_ratio()),
        stamped(cable_breaking_load()),
        stamped(cable_pressure()),
        stamped(cable_fleet()),
        stamped(cable_groove_angle()),
        stamped(cable_free_path()),
        stamped(cam_arm_range()),
        stamped(cam_contour_radius()),
        stamped(groove_depth()),
        stamped(groove_radius()),
        stamped(groove_throat()),
        stamped(groove_pitch()),
        stamped(groove_neighbour_turns()),
        stamped(spring_travel()),
        stamped(spring_torsion_angle()),
        stamped(spring_load()),
        stamped(spring_stress()),
        stamped(spring_buckling()),
        stamped(structure_wall_to_bore()),
        stamped(structure_idle_curvature()),
        stamped(structure_leg_slot()),
        stamped(structure_anchor()),
        stamped(structure_anchor_floor()),
        stamped(shaft_key()),
        stamped(shaft_screw()),
        stamped(shaft_hub_wall()),
        stamped(process_build_volume()),
        stamped(process_overhang()),
        stamped(process_support()),
        stamped(process_wall()),
        stamped(process_hole()),
        stamped(process_cutter()),
        stamped(process_undercut()),
        stamped(process_contour_error()),
    };
    return all;
}

core::Findings check(const Design& design) {
    validate(design);
    core::Findings findings;
    for (const Rule& rule : rules()) core::append(findings, rule.run(design));
    return findings;
}

core::Findings check_without_mesh(const Design& design) {
    validate(design);
    core::Findings findings;
    for (const Rule& rule : rules())
        if (!rule.needs_mesh) core::append(findings, rule.run(design));
    return findings;
}

}  // namespace fusee::checks
