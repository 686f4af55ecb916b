#include "bad_profiles.h"

namespace fusee::fix_each_rule {

namespace {

using fixtures::Changes;

/// A good profile that no rule objects to: a shipped one, changed, whose reviews are accepted.
struct Base {
    const char* shipped;
    Changes changes;
    std::string accepted;  ///< [[limits]]
};

std::string limit(const std::string& rule, const std::string& value) {
    return "\n[[limits]]\nrule = \"" + rule + "\"\n" + value + "\nreason = \"accepted\"\n";
}
const std::string kBend = limit("cable.bend_ratio", "review = 6"), kSupport = limit("fdm.support", "review_mm2 = 300");

Changes by(const char* process, const char* clearance_mm, Changes more = {}) {
    Changes all{{"process.kind", std::string("\"") + process + '"'},
                {"groove.throat_deg", "45"},
                {"k_se.hub.clearance_mm", clearance_mm},
                {"k_pe.hub.clearance_mm", clearance_mm}};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

const Base kShipped{"pnrvsa", {}, kBend + kSupport};
const Base kPrototype{"first_prototype", {}, kSupport};
const Base kRoller{"examples/roller_follower", {}, ""};
const Base kPlates{"examples/laser_stack", {{"k_se.flange_height_mm", "0.2"}, {"k_pe.flange_height_mm", "0.2"}}, ""};
const Base kResin{"pnrvsa", by("sla", "0.2"), kBend + limit("sla.drain", "review_diameters = 2")};
const Base kPowder{"pnrvsa", by("sls", "0.3"), kBend};
const Base kMilled{"first_prototype", by("mill4", "0.03", {{"k_se.hub.lock", "\"plain\""}, {"k_pe.hub.lock", "\"plain\""}}), ""};
/// pnrvsa with what the data sheets of its springs say.
const Base kSheets{"pnrvsa",
                   {{"k_se.spring.wire_mm", "1.0"},
                    {"k_se.spring.coil_mm", "10.8"},
                    {"k_se.spring.active_coils", "12"},
                    {"k_se.features.leg_slot_angle_deg", "122"},
                    {"k_se.spring.free_length_mm", "30"},
                    {"k_se.spring.tensile_strength_MPa", "2300"},
                    {"k_se.spring.max_angle_rad", "20"},
                    {"k_se.spring.max_torque_Nm", "1"},
                    {"k_pe.spring.wire_mm", "2.0"},
                    {"k_pe.spring.coil_mm", "16"},
                    {"k_pe.spring.active_coils", "8"},
                    {"k_pe.spring.free_length_mm", "70"},
                    {"k_pe.spring.tensile_strength_MPa", "2300"}},
                   kBend + kSupport + limit("assembly.anchor_reach", "review_mm = -2")};

struct Row {
    const char* rule;
    const Base* base;  ///< never null
    Changes changes;
};

const Row kRows[] = {
    {"cable.bend_ratio", &kShipped, {{"cable.diameter_mm", "1.6"}}},
    {"cable.space_bend", &kPrototype, {{"k_pe.path.lead", "\"constant_pitch\""}, {"k_pe.path.pitch_mm", "60"}}},
    {"cable.bend_strength", &kShipped, {{"cable.diameter_mm", "1.6"}, {"cable.min_bend_ratio", "1"}}},
    {"cable.breaking_load", &kShipped, {{"cable.breaking_load_N", "400"}}},
    {"cable.anchor_load", &kShipped, {{"cable.breaking_load_N", "150"}}},
    {"cable.anchor_tail", &kShipped, {{"k_se.path.margin_deg", "4"}, {"k_se.features.anchor_hole_mm", "0"}}},
    {"cable.knot", &kShipped, {{"cable.diameter_mm", "0.65"}, {"process.layer_mm", "0.1"}}},
    {"cable.pressure", &kShipped, {{"cable.max_pressure_MPa", "20"}}},
    {"cable.fleet", &kShipped, {{"k_se.guide.kind", "\"point\""}, {"k_se.guide.distance_mm", "100"}, {"k_se.guide.z_mm", "6"}}},
    {"cable.fleet_side", &kShipped, {{"k_se.guide.kind", "\"point\""}, {"k_se.guide.distance_mm", "100"}, {"k_se.guide.z_mm", "3"}}},
    {"cable.groove_angle", &kPrototype, {{"k_pe.path.lead", "\"constant_pitch\""}, {"k_pe.path.pitch_mm", "12"}}},
    {"cable.free_path", &kShipped, {{"k_pe.guide.kind", "\"point\""}, {"k_pe.guide.distance_mm", "60"}, {"k_pe.guide.z_mm", "-8"}}},
    {"cam.arm_range", &kPrototype, {{"k_se.hub.bore_mm", "29"}, {"k_se.features.anchor_hole_mm", "0"}, {"k_se.hub.lock", "\"plain\""}}},
    {"cam.contour_radius", &kPrototype, {{"k_pe.guide.distance_mm", "14"}, {"k_pe.guide.z_mm", "0"}}},
    {"groove.depth", &kPrototype, {{"groove.depth_ratio", "0.3"}}},
    {"groove.lip_height", &kPrototype, {{"cable.diameter_mm", "0.5"}}},
    {"groove.radius", &kPrototype, {{"groove.radius_ratio", "0.51"}}},
    {"groove.throat", &kPrototype, {{"groove.throat_deg", "100"}}},
    {"groove.flank_rub", &kPlates, {{"groove.plate_mm", "0.78"}}},
    {"spring.travel", &kShipped, {{"k_pe.spring.max_travel_mm", "20"}}},
    {"spring.coil_gap", &kSheets, {{"k_pe.spring.coil_mm", "32"}, {"k_pe.spring.free_length_mm", "44"}}},
    {"spring.torsion_angle", &kSheets, {{"k_se.spring.max_angle_rad", "8"}}},
    {"spring.body_growth", &kSheets, {{"k_se.spring.free_length_mm", "14"}}},
    {"spring.hand", &kShipped, {{"k_se.spring.hand", "\"right\""}}},
    {"spring.load", &kShipped, {{"k_pe.spring.max_force_N", "100"}}},
    {"spring.stress", &kSheets, {{"k_se.spring.tensile_strength_MPa", "1500"}}},
    {"spring.fatigue", &kSheets, {{"k_se.spring.cycles", "1e6"}}},
    {"spring.buckling", &kSheets, {{"k_pe.spring.free_length_mm", "200"}}},
    {"spring.index", &kSheets, {{"k_pe.spring.coil_mm", "34"}, {"k_pe.spring.tensile_strength_MPa", "0"}}},
    {"spring.active_coils", &kSheets, {{"k_pe.spring.active_coils", "2"}}},
    {"spring.rod", &kSheets, {{"k_se.spring.rod_mm", "8.5"}}},
    {"spring.rate_scatter", &kSheets, {{"k_se.spring.max_angle_rad", "8.9"}}},
    {"structure.wall_to_bore", &kShipped, {{"k_pe.hub.web_mm", "0.5"}}},
    {"structure.leg_slot", &kShipped, {{"k_se.features.leg_slot_radius_mm", "4.6"}}},
    {"structure.slot_floor", &kShipped, {{"k_se.features.leg_slot_depth_mm", "3.8"}}},
    {"structure.anchor", &kShipped, {{"k_se.features.leg_slot_angle_deg", "51"}}},
    {"structure.anchor_floor", &kShipped, {{"k_pe.path.margin_deg", "12"}}},
    {"structure.hole_edge", &kShipped, {{"cable.diameter_mm", "0.7"}}},
    {"structure.flange_slenderness", &kShipped, {{"k_se.flange_height_mm", "5"}}},
    {"shaft.bore_fit", &kShipped, {{"k_se.hub.clearance_mm", "0.5"}}},
    {"shaft.hub_length", &kShipped, {{"k_pe.hub.boss_height_mm", "4"}}},
    {"shaft.hub_wall", &kShipped, {{"k_pe.hub.boss_mm", "10"}}},
    {"shaft.key", &kShipped, {{"k_se.hub.key_width_mm", "3"}}},
    {"shaft.key_pressure", &kShipped, {{"cable.max_pressure_MPa", "30"}, {"cable.diameter_mm", "0.8"}}},
    {"shaft.screw", &kShipped, {{"k_pe.hub.lock", "\"set_screw\""}, {"k_pe.hub.screw_mm", "4"}}},
    {"shaft.screw_torque", &kShipped, {{"k_pe.hub.lock", "\"set_screw\""}, {"k_pe.hub.screw_mm", "2"}}},
    {"shaft.d_flat", &kPrototype, {{"k_se.hub.flat_depth_mm", "0.24"}}},
    {"roller.pressure_angle", &kRoller, {{"k_pe.roller.offset_mm", "-31.9"}}},
    {"roller.undercut", &kRoller, {{"k_pe.roller.radius_mm", "1000"}}},
    {"roller.contact_pressure", &kRoller, {{"k_pe.roller.max_pressure_MPa", "30"}}},
    {"roller.rim_width", &kRoller, {{"k_pe.roller.width_mm", "7"}}},
    {"roller.lift_off",
     &kRoller,
     {{"k_pe.spring.preload_mm", "0.4"},
      {"k_pe.spring.rate_N_per_m", "20000"},
      {"k_pe.roller.base_radius_mm", "200"},
      {"process.build_mm", "[600.0, 600.0, 200.0]"}}},
    {"process.build_volume", &kShipped, {{"process.build_mm", "[30.0, 30.0, 30.0]"}}},
    {"process.wall", &kShipped, {{"groove.rib_mm", "0.5"}}},
    {"process.hole", &kShipped, {{"k_se.features.anchor_hole_mm", "1.5"}}},
    {"process.detail", &kShipped, {{"k_se.features.mark_width_mm", "0.3"}}},
    {"process.contour_error", &kShipped, {{"process.tolerance_mm", "0.6"}}},
    {"fdm.support", &kShipped, {}},
    {"fdm.bridge",
     &kShipped,
     {{"k_pe.hub.bore_mm", "12"},
      {"k_pe.hub.key_width_mm", "4"},
      {"k_pe.hub.key_depth_mm", "1.8"},
      {"k_pe.hub.boss_mm", "24"},
      {"k_pe.hub.boss_height_mm", "15"}}},
    {"fdm.layers", &kShipped, {{"process.layer_mm", "0.3"}}},
    {"fdm.elephant_foot", &kShipped, {{"k_se.hub.clearance_mm", "0.15"}}},
    {"sla.drain", &kResin, {}},
    {"sla.support", &kResin, {{"groove.throat_deg", "36"}}},
    {"sls.hole_depth", &kPowder, {{"groove.rib_mm", "14"}, {"k_se.features.anchor_hole_mm", "1.5"}}},
    {"sls.groove", &kPowder, {{"cable.diameter_mm", "0.4"}}},
    {"mill.slot_width",
     &kMilled,
     {{"k_se.features.leg_slot_width_mm", "0.7"},
      {"k_se.features.leg_slot_length_mm", "2"},
      {"k_se.features.leg_slot_depth_mm", "0.9"},
      {"k_se.features.leg_slot_radius_mm", "6.5"},
      {"process.cutter_radius_mm", "0.4"}}},
    {"mill.pocket",
     &kMilled,
     {{"k_se.features.leg_slot_width_mm", "1.0"},
      {"k_se.features.leg_slot_length_mm", "2"},
      {"k_se.features.leg_slot_depth_mm", "1.7"},
      {"k_se.features.leg_slot_radius_mm", "7"},
      {"groove.rib_mm", "2"}}},
    {"mill.inner_edge", &kMilled, {{"k_se.hub.lock", "\"d_flat\""}}},
    {"mill.hole_depth", &kMilled, {{"groove.rib_mm", "7"}}},
    {"mill4.reach", &kMilled, {{"k_se.flange_height_mm", "1.5"}}},
    {"mill4.swing", &kMilled, {{"process.build_mm", "[30.0, 30.0, 200.0]"}}},
    {"stack.wire", &kPlates, {{"process.cutter_radius_mm", "1.5"}}},
    {"stack.kerf", &kPlates, {{"process.cutter_radius_mm", "0.95"}, {"k_pe.hub.key_width_mm", "1.5"}}},
    {"stack.groove_width", &kPlates, {{"groove.plate_mm", "0.78"}}},
    {"stack.plate", &kPlates, {{"groove.plate_mm", "0.4"}, {"cable.diameter_mm", "0.38"}}},
    {"stack.hole", &kPlates, {{"groove.rib_mm", "3"}, {"k_se.features.leg_slot_depth_mm", "3"}}},
    {"stack.slot_depth", &kPlates, {{"k_se.features.leg_slot_depth_mm", "1.3"}}},
    {"stack.dowels", &kPlates, {{"k_pe.hub.bore_mm", "13"}, {"k_pe.hub.lock", "\"plain\""}, {"k_pe.features.anchor_hole_mm", "0"}}},
    {"stack.boss", &kPlates, {{"k_pe.hub.boss_mm", "14"}, {"k_pe.hub.boss_height_mm", "5"}}},
    {"stack.climb", &kPlates, {{"k_pe.path.kind", "\"helix\""}, {"k_pe.path.pitch_mm", "4"}}},
    {"assembly.thread", &kResin, {{"k_se.features.anchor_hole_mm", "0.9"}}},
    {"assembly.anchor_reach", &kSheets, {}},
    {"assembly.leg_width", &kSheets, {{"k_se.features.leg_slot_width_mm", "0.9"}}},
    {"assembly.leg_radius", &kSheets, {{"k_se.spring.coil_mm", "9"}}},
    {"assembly.rotation_gap", &kPrototype, {{"k_pe.guide.distance_mm", "14.8"}, {"k_pe.guide.z_mm", "0"}}},
    {"collision.ball_cutter", &kMilled, {{"process.cutter_radius_mm", "0.5"}}},
    {"collision.printed_throat", &kShipped, {{"groove.throat_deg", "60"}}},
    {"collision.rim_undercut", &kMilled, {{"process.kind", "\"mill\""}}},
};

/// Without what was accepted of one rule.
std::string without(std::string limits, const std::string& rule) {
    const std::size_t at = limits.find("\n[[limits]]\nrule = \"" + rule + '"');
    if (at == std::string::npos) return limits;
    const std::size_t next = limits.find("\n[[limits]]", at + 1);
    return limits.erase(at, next == std::string::npos ? next : next - at);
}

/// Short to make: one mesh of each part.
const Changes kMeshOnly = {{"outputs.formats", "[\"stl\"]"}, {"outputs.pair", "false"}};

}  // namespace

std::vector<BadProfile> bad_profiles() {
    std::vector<BadProfile> all;
    for (const Row& row : kRows) {
        const std::string shipped = core::read_file(fixtures::shipped(row.base->shipped));
        const std::string good = fixtures::with_keys(fixtures::with_keys(shipped, kMeshOnly), row.base->changes);
        all.push_back({row.rule, fixtures::with_keys(good, row.changes) + without(row.base->accepted, row.rule), row.changes});
    }
    return all;
}

}  // namespace fusee::fix_each_rule
