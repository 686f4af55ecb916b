#include "key.h"

namespace fusee::profile {

namespace {

/// The part of a table: "cam" is that of a single spring.
struct PartOf {
    std::string table;
    template <class AnyProfile>
    auto& operator()(AnyProfile& p) const {
        return table == "cam" ? p.part(p.part_kinds().front())
                              : p.part(table == "k_se" ? cam::PartKind::kSeries : cam::PartKind::kParallel);
    }
};

#define OF(field) \
    [of](auto& p) -> auto& { return of(p).field; }

constexpr const char* kFamily = "cam.family";

/// A key of a spool and its torsion spring, of K_SE or of a single spring.
Key of_spool(const std::string& part, Key key) { return part == "cam" ? when(kFamily, {"spool"}, std::move(key)) : key; }

/// Which of both parts of a joint the single spring's part is like.
Key family_key() {
    return required(choice(
        kFamily, {"spool", "cable", "two_cables", "roller"},
        "spool: its cable pulls a pulley, behind it a torsion spring; cable, roller: turns with the angle and moves a compression spring, "
        "by a cable in a groove or by a follower's roller on a rim; two_cables: two such cable parts on one shaft, one each way, each with "
        "its spring; a torque that changes its sign needs two_cables or a roller",
        [](auto& p) -> auto& { return std::get<OneSpring>(p.law.curves).family; }));
}

Key pulley_key() {
    return when(kFamily, {"spool"},
                required(number("cam.pulley_radius_mm", above(0, 1000), "radius at which the cable acts about the axis of the law's angle",
                                FIELD(rig.capstan_radius))));
}

/// Keys of two cables alone.
Key of_two(Key key) { return when(kFamily, {"two_cables"}, std::move(key)); }

#define TWO(member) \
    [](auto& p) -> auto& { return std::get<OneSpring>(p.law.curves).two_cables.member; }

Key least_torque_key() {
    return of_two(required(number("cam.least_torque_Nm", above(0, 1e4),
                                  "that each of both cables keeps, so that it stays taut; where the law is 0 each pulls with twice as much",
                                  TWO(least_torque))));
}

/// What the way back has of its own; all else in [cam] is of both cables.
std::vector<Key> back_keys() {
    return {of_two(number("cam.back.preload_mm", or_zero(1e-3, 1e4),
                          "y0 of the spring that pulls back, at the last angle; 0 = cam.spring.preload_mm", TWO(back_preload))),
            of_two(number("cam.back.turned_deg", within(-360, 360),
                          "direction of the guide of the cable that pulls back, from cam.guide.direction_deg", TWO(back_turned)))};
}

#undef TWO

std::vector<Key> body_keys(const std::string& part, const PartOf& of) {
    std::vector<Key> all{
        sign(part + ".torque_sign", "sign of the tension's torque about +z", OF(cam.torque_sign)),
        integer(part + ".target_rows", within(200, 10000), "working positions in PART.json", OF(cam.target_rows)),
        number(part + ".flange_height_mm", within(0, 100), "height of the flanges above the groove's lips", OF(solid.flange_height)),
        number(part + ".radius_allowance_mm", within(-100, 100),
               "excess of every arm on the rig (cable, overcut): the cam is cut with arms smaller by it", OF(allowance.radius)),
        number(part + ".cable_length_mm", within(0, 1e5),
               "unloaded, from the anchor on the cam to what it pulls; the cam is cut for its stretch; 0 = rigid", OF(cable_length)),
    };
    if (part != "k_pe")
        all.push_back(of_spool(part, number(part + ".cable_compliance_rad_per_Nm", within(0, 1e3),
                                            "additional to that of " + part +
                                                ".cable_length_mm, behind the spool, at the capstan, for example from a diagnosis; the sum "
                                                "is below 1/S of the law",
                                            OF(allowance.series_compliance))));
    if (part == "k_pe")
        all.insert(all.begin(),
                   choice("k_pe.family", {"cable", "roller"}, "a cable in a groove, or a follower's roller on a rim", OF(cam.family)));
    if (part == "cam") {
        all.insert(all.begin(), {family_key(), pulley_key(), least_torque_key()});
        for (Key& key : back_keys()) all.push_back(std::move(key));
    }
    return all;
}

/// The two base springs differ in what they measure: angle and torque, or travel and force.
std::vector<Key> spring_keys(const std::string& part, const PartOf& of) {
    const std::string t = part + ".spring.";
    std::vector<Key> all;
    const auto torsion = [&](Key key) {
        if (part != "k_pe") all.push_back(of_spool(part, std::move(key)));
    };
    const auto compression = [&](Key key) {
        if (part == "cam") key = when(kFamily, {"cable", "two_cables", "roller"}, std::move(key));
        if (part != "k_se") all.push_back(std::move(key));
    };
    torsion(required(number(t + "rate_Nm_per_rad", above(0, 1e6), "k_t of the torsion spring, as measured; left out: that of its coils",
                            OF(spring.rate))));
    torsion(required(number(t + "preload_rad", within(0, 1e3), "phi0, wound at the law's lowest load", OF(spring.preload))));
    torsion(number(t + "max_angle_rad", within(0, 1e3), "largest allowed winding, preload counted; 0 = by the wire's strength",
                   OF(spring.max_state)));
    torsion(number(t + "max_torque_Nm", within(0, 1e4), "0 = by the wire's strength", OF(spring.max_load)));
    compression(required(number(t + "rate_N_per_m", above(0, 1e9), "k of the compression spring, as measured; left out: that of its coils",
                                OF(spring.rate))));
    compression(required(number(t + "preload_mm", within(0, 1e4), "y0, compressed at the law's lowest load", OF(spring.preload))));
    compression(number(t + "max_travel_mm", within(0, 1e4), "travel to solid, preload counted; 0 = by coils and strength of the wire",
                       OF(spring.max_state)));
    compression(number(t + "max_force_N", within(0, 1e6), "0 = by coils and strength of the wire", OF(spring.max_load)));
    all.push_back(choice(t + "rate_origin", {"nominal", "measured"}, "nominal: that of wire, coil and turns; measured: of this spring",
                         OF(spring.rate_origin)));
    all.push_back(number(t + "wire_mm", or_zero(0.02, 100), "wire diameter; 0 = unknown, stress not checked", OF(spring.wire_diameter)));
    all.push_back(number(t + "coil_mm", or_zero(0.1, 1000), "mean coil diameter; 0 = unknown", OF(spring.coil_diameter)));
    all.push_back(
        number(t + "active_coils", or_zero(0.1, 1000), "0 = those that give wire_mm and coil_mm the rate", OF(spring.active_coils)));
    all.push_back(number(t + "free_length_mm", or_zero(0.1, 1e4),
                         part == "k_se" ? "axial space for the body; 0 = as the wound coils need" : "0 = as turns and travel need",
                         OF(spring.free_length)));
    all.push_back(number(t + "tensile_strength_MPa", or_zero(100, 5000), "of the wire; 0 = by wire_class", OF(spring.tensile_strength)));
    all.push_back(choice(t + "wire_class", {spring::kWireClassNames.begin(), spring::kWireClassNames.end()},
                         "of EN 10270-1: its least strength at this diameter; unknown: stress not checked without tensile_strength_MPa",
                         OF(spring.wire_class)));
    torsion(number(t + "youngs_modulus_MPa", above(0, 1e6), "E of the wire, for the rate of its coils", OF(spring.youngs_modulus)));
    torsion(number(t + "leg_bend_mm", or_zero(0.01, 100), "inner radius of the bend to the leg; 0 = wire_mm", OF(spring.leg_bend_radius)));
    compression(number(t + "shear_modulus_MPa", above(0, 1e6), "G of the wire, for the rate of its coils", OF(spring.shear_modulus)));
    all.push_back(
        number(t + "stress_share", within(0, 1),
               "allowed share of it; 0 = 0.7 of torsion springs, 0.8 of compression springs, over sqrt 3 in shear; 0.6 for stainless 302",
               OF(spring.stress_share)));
    all.push_back(choice(t + "hand", {"unknown", "right", "left"}, "of the coil; right: like a common screw", OF(spring.hand)));
    all.push_back(number(t + "rod_mm", or_zero(0.1, 1000),
                         part == "k_se" ? "diameter of the arbor inside the coils: more than hub.bore_mm is a sleeve on the axle, less is "
                                          "the axle turned down; 0 = the axle itself, of an overhung hub unknown"
                                        : "diameter of the guide rod inside the coils; 0 = unknown",
                         OF(spring.rod_diameter)));
    all.push_back(
        number(t + "cycles", or_zero(1, 1e12), "wanted load cycles over the working range; 0 = fatigue not checked", OF(spring.cycles)));
    all.push_back(number(t + "motion_Hz", within(0.01, 1e4), "fastest motion that loads the spring; default assumed", OF(spring.motion)));
    return all;
}

std::vector<Key> guide_keys(const std::string& part, const PartOf& of) {
    const std::string t = part + ".guide.", kind = t + "kind";
    return {
        choice(kind, {"parallel", "point", "idler"}, "where the cable goes: straight off, to a point, over an idler", OF(cam.guide.kind)),
        number(t + "direction_deg", within(-360, 360), "parallel: along the cable, away from the cam; else towards the guide's centre",
               OF(cam.guide.direction)),
        number(t + "distance_mm", within(0, 1e4),
               "cam axis to the guide's centre, above 0; parallel: to the hole that the cable goes to, from which follows how far the arms "
               "are "
               "off; 0 = not stated",
               OF(cam.guide.distance)),
        when(kind, {"idler"}, required(number(t + "radius_mm", above(0, 1000), "pitch radius of the idler", OF(cam.guide.radius)))),
        when(kind, {"idler"}, sign(t + "sense", "side on which the cable passes the idler's centre", OF(cam.guide.sense))),
        number(t + "z_mm", within(-1e4, 1e4), "height of the guide: the fleet angle of the cable depends on it, and a path may aim at it",
               OF(cam.guide.z)),
    };
}

std::vector<Key> path_keys(const std::string& part, const PartOf& of) {
    const std::string t = part + ".path.", kind = t + "kind";
    return {
        choice(kind, {"planar", "helix"}, "one closed turn, or a rising groove of as many turns as the law needs", OF(cam.path.kind)),
        when(kind, {"helix"},
             choice(t + "lead", {"constant_pitch", "aimed"}, "aimed: rises so that the cable always points at the guide",
                    OF(cam.path.lead))),
        when(kind, {"helix"},
             number(t + "pitch_mm", within(0, 1000), "height gained per turn; above 0 for a constant pitch", OF(cam.path.pitch))),
        when(kind, {"helix"},
             when(t + "lead", {"constant_pitch"}, choice(t + "hand", {"right", "left"}, "right: like a common screw", OF(cam.path.hand)))),
        number(t + "margin_deg", within(3, 170),
               "groove beyond the working arc, to the anchor; left out: the nearest angle at which no rule objects", OF(cam.path.margin)),
        number(t + "min_idle_radius_mm", above(0, 1000), "least radius of curvature on the idle arc that closes a planar path",
               OF(cam.path.min_idle_curvature_radius)),
    };
}

/// The keys of K_PE's roller, which do not apply to a cable.
std::vector<Key> roller_keys(const std::string& part, const PartOf& of) {
    if (part == "k_se") return {};
    const std::string t = part + ".roller.", follower = t + "follower";
    const auto of_arm = [&](Key key) { return when(follower, {"arm"}, required(std::move(key))); };
    std::vector<Key> all{
        choice(follower, {"slide", "arm"}, "what guides the roller: a slide along a line, or an arm on a pivot", OF(cam.roller.follower)),
        number(t + "radius_mm", above(0, 1000), "of the roller", OF(cam.roller.radius)),
        number(t + "base_radius_mm", above(0, 1000), "axis to the roller's centre at the law's lowest load, minus the roller's radius",
               OF(cam.roller.base_radius)),
        when(follower, {"slide"},
             number(t + "offset_mm", within(-1000, 1000), "of the follower's line from the axis; above 0 eases the rise",
                    OF(cam.roller.offset))),
        number(t + "direction_deg", within(-360, 360),
               "slide: along its line, away from the axis, as the spring is compressed; arm: from the axis to the pivot",
               OF(cam.roller.direction)),
        of_arm(number(t + "arm_mm", above(0, 1e4), "pivot to the roller's centre", OF(cam.roller.arm.length))),
        of_arm(number(t + "pivot_mm", above(0, 1e4), "axis to pivot", OF(cam.roller.arm.pivot))),
        when(follower, {"arm"},
             sign(t + "side", "1: the roller is counter-clockwise of the line from the axis to the pivot", OF(cam.roller.arm.side))),
        of_arm(number(t + "lever_mm", above(0, 1e4), "pivot to the spring's pin on the arm", OF(cam.roller.arm.lever))),
        of_arm(number(t + "spring_mm", above(0, 1e4), "between the spring's pins at the law's lowest load, at a right angle to the lever",
                      OF(cam.roller.arm.spring))),
        number(t + "width_mm", above(0, 1000), "of the roller", OF(cam.roller.width)),
        number(t + "rim_width_mm", above(0, 1000), "thickness of the cam's plate, two ribs included", OF(solid.rim_width)),
        number(t + "contact_modulus_MPa", or_zero(10, 1e6), "E* of cam and roller: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2",
               OF(cam.roller.contact_modulus)),
        number(t + "max_pressure_MPa", or_zero(0.1, 1e4), "allowed contact pressure of cam and roller; 0 = not checked",
               OF(cam.roller.max_pressure)),
    };
    for (Key& key : all) key = when(part + ".family", {"roller"}, std::move(key));
    return all;
}

/// Does the key belong to the cable, which a roller cam does not have?
bool of_cable(const Key& key, const std::string& part) {
    for (const char* leaf : {".flange_height_mm", ".radius_allowance_mm", ".cable_length_mm", ".path.margin_deg",
                             ".features.anchor_hole_mm", ".features.anchor_edge_mm"})
        if (key.path == part + leaf) return true;
    return key.table() == part + ".guide";
}

std::vector<Key> hub_keys(const std::string& part, const PartOf& of) {
    const std::string t = part + ".hub.";
    const Limits length = within(0, 1000);
    return {
        choice(t + "kind", {"through", "overhung"}, "overhung: a blind bore in a boss below, for arms too short to hold a shaft",
               OF(solid.hub.kind)),
        choice(t + "lock", {"plain", "keyway", "d_flat", "set_screw"}, "what holds the shaft", OF(solid.hub.lock)),
        number(t + "bore_mm", above(0, 1000), "shaft diameter", OF(solid.hub.bore_diameter)),
        number(t + "clearance_mm", within(0, 2), "added to the bore's diameter", OF(solid.hub.bore_clearance)),
        number(t + "key_width_mm", length, "keyway: b of DIN 6885-1", OF(solid.hub.key_width)),
        number(t + "key_depth_mm", length, "keyway: t2 of DIN 6885-1, beyond the bore's radius", OF(solid.hub.key_depth)),
        choice(t + "key_fit", {"as_made", "by_hand"}, "keyway: as the process leaves it, or filed or broached to its key",
               OF(solid.hub.key_fit)),
        number(t + "flat_depth_mm", length, "d_flat: bore radius minus the flat's distance from the axis", OF(solid.hub.flat_depth)),
        number(t + "screw_mm", length, "set_screw: diameter of the radial hole in the boss", OF(solid.hub.screw_diameter)),
        number(t + "boss_mm", length, "diameter of the boss: overhung and set_screw", OF(solid.hub.boss_diameter)),
        number(t + "boss_height_mm", length, "below the lower flange; 0 = no boss", OF(solid.hub.boss_height)),
        number(t + "web_mm", length, "overhung: material above the blind bore's end", OF(solid.hub.web)),
    };
}

std::vector<Key> feature_keys(const std::string& part, const PartOf& of) {
    const std::string t = part + ".features.";
    const Limits length = within(0, 1000);
    return {
        number(t + "anchor_hole_mm", length, "axial hole for the cable's end on the groove's floor; 0 = none",
               OF(solid.features.anchor_hole_diameter)),
        number(t + "anchor_edge_mm", length, "radius to which that hole's edge is rounded by hand; 0 = sharp",
               OF(solid.features.anchor_edge_radius)),
        number(t + "leg_slot_width_mm", length, "slot for the spring's leg: wire and clearance; 0 = none",
               OF(solid.features.leg_slot_width)),
        number(t + "leg_slot_length_mm", length, "radial", OF(solid.features.leg_slot_length)),
        number(t + "leg_slot_radius_mm", length, "its middle, from the axis", OF(solid.features.leg_slot_radius)),
        number(t + "leg_slot_depth_mm", length, "from the top face", OF(solid.features.leg_slot_depth)),
        number(t + "leg_slot_angle_deg", within(-360, 360), "in the part's frame", OF(solid.features.leg_slot_angle)),
        number(t + "mark_width_mm", length,
               "timing mark at angle 0 on the top face, at 180 deg where the anchor hole leaves no wall beside it; 0 = none",
               OF(solid.features.mark_width)),
        number(t + "mark_depth_mm", length, "of the timing mark", OF(solid.features.mark_depth)),
    };
}

#undef OF

}  // namespace

std::vector<Key> part_keys(const std::string& part) {
    std::vector<Key> all;
    for (const auto share : {body_keys, roller_keys, spring_keys, guide_keys, path_keys, hub_keys, feature_keys})
        for (Key& key : share(part, {part})) {
            if (part == "k_pe" && of_cable(key, part)) key = when("k_pe.family", {"cable"}, std::move(key));
            if (part == "cam" && of_cable(key, part)) key = when(kFamily, {"spool", "cable", "two_cables"}, std::move(key));
            all.push_back(std::move(key));
        }
    return all;
}

}  // namespace fusee::profile
