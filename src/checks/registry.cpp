#include <algorithm>
#include <array>
#include <cassert>

#include "family.h"
#include "fusee/core/error.h"
#include "rules.h"

namespace fusee::checks {

namespace {

struct Group {
    std::string_view id;
    const char* title;
};
constexpr std::array kGroups = {
    Group{"cable", "the cable on its way"},
    Group{"cam", "arms and the room that the cam turns in"},
    Group{"groove", "the groove's section"},
    Group{"spring", "the base spring"},
    Group{"structure", "walls, flanges and the anchor"},
    Group{"shaft", "shaft and hub"},
    Group{"roller", "a follower's roller on the rim"},
    Group{"process", "any process"},
    Group{"fdm", "printing filament"},
    Group{"sla", "printing resin"},
    Group{"sls", "printing powder"},
    Group{"mill", "milling, three or four axes"},
    Group{"mill4", "milling with a fourth axis"},
    Group{"stack", "plates cut by wire or laser, stacked"},
    Group{"assembly", "putting it together"},
    Group{"collision", "rules of the trade that contradict each other"},
    Group{"mesh", "a mesh by anybody (fusee check)"},
};

void validate(const Design& design) {
    core::require_positive("cable.diameter", design.cable.diameter, "m");
    const spring::BaseSpring& spring = design.spring;
    core::require_positive("spring.rate", spring.rate);
    if (spring.wire_diameter > 0.0 && spring.coil_diameter > 0.0 && spring.coil_diameter <= spring.wire_diameter)
        throw core::InvalidInput("spring.coil_diameter", std::to_string(spring.coil_diameter), "above the wire's diameter [m]");
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
    static const std::array all = {cable_bend_ratio(),
                                   cable_space_bend(),
                                   cable_bend_strength(),
                                   cable_breaking_load(),
                                   cable_anchor_load(),
                                   cable_anchor_tail(),
                                   cable_knot(),
                                   cable_slack(),
                                   cable_pressure(),
                                   cable_fleet(),
                                   cable_fleet_side(),
                                   cable_groove_angle(),
                                   cable_free_path(),
                                   cam_arm_range(),
                                   cam_contour_radius(),
                                   groove_depth(),
                                   groove_lip_height(),
                                   groove_radius(),
                                   groove_throat(),
                                   groove_flank_rub(),
                                   groove_pitch(),
                                   groove_neighbour_turns(),
                                   spring_travel(),
                                   spring_coil_gap(),
                                   spring_torsion_angle(),
                                   spring_body_growth(),
                                   spring_unwinding(),
                                   spring_hand(),
                                   spring_load(),
                                   spring_stress(),
                                   spring_fatigue(),
                                   spring_buckling(),
                                   spring_index(),
                                   spring_active_coils(),
                                   spring_rod(),
                                   spring_rate_scatter(),
                                   structure_wall_to_bore(),
                                   structure_neck(),
                                   structure_idle_curvature(),
                                   structure_leg_slot(),
                                   structure_slot_floor(),
                                   structure_anchor(),
                                   structure_anchor_floor(),
                                   structure_hole_edge(),
                                   structure_flange_bending(),
                                   structure_flange_slenderness(),
                                   shaft_bore_fit(),
                                   shaft_hub_length(),
                                   shaft_hub_wall(),
                                   shaft_key(),
                                   shaft_key_pressure(),
                                   shaft_screw(),
                                   shaft_screw_torque(),
                                   shaft_d_flat(),
                                   roller_pressure_angle(),
                                   roller_undercut(),
                                   roller_contact_pressure(),
                                   roller_rim_width(),
                                   roller_lift_off(),
                                   process_build_volume(),
                                   process_wall(),
                                   process_hole(),
                                   process_detail(),
                                   process_contour_error(),
                                   fdm_support(),
                                   fdm_bridge(),
                                   fdm_layers(),
                                   fdm_elephant_foot(),
                                   sla_drain(),
                                   sla_support(),
                                   sls_hole_depth(),
                                   sls_groove(),
                                   mill_slot_width(),
                                   mill_pocket(),
                                   mill_inner_edge(),
                                   mill_hole_depth(),
                                   mill4_reach(),
                                   mill4_swing(),
                                   stack_wire(),
                                   stack_kerf(),
                                   stack_groove_width(),
                                   stack_plate(),
                                   stack_hole(),
                                   stack_dowels(),
                                   stack_boss(),
                                   stack_climb(),
                                   assembly_thread(),
                                   assembly_anchor_reach(),
                                   assembly_leg_width(),
                                   assembly_leg_radius(),
                                   assembly_rotation_gap(),
                                   collision_ball_cutter(),
                                   collision_printed_throat(),
                                   collision_printed_land(),
                                   collision_rim_undercut()};
    return all;
}

const Rule* find_rule(std::string_view id) {
    const auto found = std::find_if(rules().begin(), rules().end(), [id](const Rule& rule) { return rule.id == id; });
    return found == rules().end() ? nullptr : &*found;
}

const char* group_title(std::string_view group) {
    const auto found = std::find_if(kGroups.begin(), kGroups.end(), [group](const Group& g) { return g.id == group; });
    assert(found != kGroups.end() && "every group of rules has its title here");
    return found->title;
}

core::Findings check(const Design& design) { return run_all(design, true); }

core::Findings check_without_mesh(const Design& design) { return run_all(design, false); }

}  // namespace fusee::checks
