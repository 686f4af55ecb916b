#include <span>

#include "explain/entry.h"
#include "fusee/report/diagnosis.h"

// Ids that no registry holds: a step that refuses a design, a stage of a search, an effect of a subsystem case, a fault of the benchmark.
namespace fusee::app {

namespace {

constexpr const char* kReport = "none: report the program as an error of fusee";

struct Row {
    std::string_view id, meaning, remedy = "";
};

constexpr Row kStepFindings[] = {
    {"brep.validity", "OpenCASCADE makes no valid exact solid of the part, so no STEP file is written",
     "another path or hub; or outputs.formats without \"step\""},
    {"cable.length", "the cable that the profile states is too short for the cam's working arc and the way to its anchor",
     "the stated k_se.cable_length_mm or k_pe.cable_length_mm, greater by the free cable"},
    {"cam.arm", "the spring and the law ask for a lever arm that no part has",
     "another rate or preload of the base spring, as the message states"},
    {"cam.convexity", "the contour would be hollow: a taut cable cannot lie in it",
     "another rate or preload of the base spring, or a range of torques that bends less"},
    {"cam.guide", "the guide is too near: no straight cable from the cam to it has the arm", "a greater guide.distance_mm"},
    {"cam.wrap", "a planar cam holds less than a turn of cable", "path.kind = \"helix\", or a smaller travel"},
    {"cam.certificate", "interval arithmetic proves, or refutes, that the contour is convex and the cable unrolls in order",
     "refuted: another base spring or law; not proven: a law of formulas, tables or knots"},
    {"cam.idle_arc", "the arc without cable cannot close the contour with the least radius",
     "a smaller path.min_idle_radius_mm, path.kind = \"helix\", or less wrap"},
    {"coupon.build_volume", "a test piece does not fit into the machine", "process.build_mm of a larger machine"},
    {"coupon.validity", "the solid of a test piece is not closed or intersects itself", "another bore or groove"},
    {"equilibrium.convexity", "a spring has a negative stiffness at a resting place: the place is not unique",
     "springs that stiffen, or a smaller load"},
    {"equilibrium.free", "no spring holds a motion of the joint", "a spring to the ground"},
    {"equilibrium.outside", "a spring of the joint leaves its law at the resting place: it is slack or wound beyond it",
     "other torques, or springs with a wider law"},
    {"joint.guide", "the assembly is not modelled: a parallel cable exit has no place for its guide",
     "guide.kind = \"point\" of the part, with guide.distance_mm"},
    {"joint.roller", "the assembly is not modelled: a roller runs on the cam", "family = \"cable\" of the part"},
    {"joint.spring_space", "the gaps round a base spring are not judged: its wire or coil is not stated",
     "spring.wire_mm, spring.coil_mm and the number of coils or the free length of the part"},
    {"law.covers_greatest", "the springs end below the load that a resting capstan can carry at the greatest torque",
     "a greater law.end_torque_Nm or a smaller rig.overdrive_torque_Nm"},
    {"law.covers_least", "the springs begin above the load that a resting capstan can carry at the least torque",
     "a greater rig.least_torque_Nm or law.lead_in_deg, or a smaller law.start_torque_Nm"},
    {"law.dead_band", "the wanted dead-band is narrower than the stiffest K_PE gives", "a wider law.dead_band_deg there"},
    {"law.energy", "a single spring whose preload holds less energy than its law takes out of it",
     "a greater cam.spring.preload_mm or preload_rad, as the message states"},
    {"law.lead_in", "a spring's stiffness or torque falls to 0 within the lead-in", "a shorter law.lead_in_deg"},
    {"law.range", "the potentials do not reach the torque at an end of the law", "law.start_torque_Nm, law.end_torque_Nm"},
    {"law.rows", "measured rows lie farther from the smoothed law than their noise: it rounds a jump or a kink",
     "a greater law.knots and law.smoothing = 0, or rows without the jump"},
    {"law.stiffness", "the law asks for a spring without stiffness, or with a negative one", "other constants of [law]"},
    {"law.torque", "the law asks a cable to push", "other constants of [law]"},
    {"law.transmission", "the transmission T of the law leaves 0 to 1 at an end: one spring would need no stiffness",
     "law.start_torque_Nm or law.end_torque_Nm, as the message states"},
    {"millsim.approach", "in the simulated mill Z is moved after a tool change before X and Y are", kReport},
    {"millsim.arc_mode", "the G-code has arcs without G91.1, which says what I and J are measured from", kReport},
    {"millsim.board", "in the simulated mill the cutter plunges too deep into the board", "machining.breakthrough_mm"},
    {"millsim.clamp", "in the simulated mill the holder or the cutter hits a clamp or the chuck",
     "machining.stick_out_mm, machining.chuck_diameter_mm or machining.chuck_grip_mm"},
    {"millsim.excess", "the G-code leaves material in the drawn groove", "a smaller machining.tool_diameter_mm"},
    {"millsim.free", "in the simulated mill a piece is cut free that neither clamp nor tab holds",
     "machining.tabs, or a smaller machining.tab_width_mm"},
    {"millsim.gouge", "the G-code cuts into the drawn part", "a smaller machining.tool_diameter_mm"},
    {"millsim.holder", "in the simulated mill the holder hits the stock", "a greater machining.stick_out_mm"},
    {"millsim.hole", "in the simulated mill a drilled hole is not at its full diameter down to its bottom", kReport},
    {"millsim.index", "the blank does not bring the hole by which the rotary axis is set, or A is stated wrongly for it", kReport},
    {"millsim.rapid", "in the simulated mill a rapid move (G0) goes through material", "a greater machining.safe_height_mm"},
    {"millsim.reamer", "in the simulated mill a reamer is pushed deeper than its hole is drilled", kReport},
    {"millsim.safe_height", "in the simulated mill a rapid move across runs lower than the top of the clamps",
     "a greater machining.safe_height_mm"},
    {"millsim.shank", "in the simulated mill the shank rubs on the stock", "a greater machining.flute_length_mm"},
    {"millsim.spindle", "the G-code feeds without M3 after the last stop or tool change", kReport},
    {"millsim.tool_change", "the G-code changes a tool where the spindle is not known to stand clear", kReport},
    {"millsim.tool_length", "the G-code moves Z without G43 and the H of the tool in the spindle", kReport},
    {"noise.unbounded", "noise drives a motion of the joint arbitrarily far: nothing holds or damps it",
     "a spring to the ground, or damping"},
    {"plate.bed", "the parts do not fit on one bed: plate.3mf is not written", "process.build_mm of a larger bed"},
    {"readback.arm", "the lever arm that another library measures in a file is not the drawn one: the file is dropped",
     "the change that the message names"},
    {"readback.bore", "the compensated file does not give the drawn bore",
     "compensation.bore_offset_mm = 0; and report it: it is a fault of fusee"},
    {"readback.interpreter", "LinuxCNC is missing: the G-code was not interpreted", "rs274 of linuxcnc-uspace"},
    {"readback.sliced", "the lever arm on the sliced beads is further off than half a layer",
     "groove.throat_deg = 60, or a smaller process.layer_mm"},
    {"readback.slicer", "PrusaSlicer is missing: the part was not sliced", "prusa-slicer"},
    {"readback.torque", "the difference of two cables' torques, by the arms of their files, is not the law: the files are dropped",
     "tolerances.chordal_error_mm"},
    {"solid.anchor", "the anchor hole is wider than the part there", "a smaller features.anchor_hole_mm or hub.bore_mm"},
    {"solid.axis", "the contour does not enclose the shaft's axis", "path.kind = \"helix\", or a base spring whose arms differ less"},
    {"solid.bore", "the bore breaks into the floor of the groove", "a smaller hub.bore_mm, or hub.kind = \"overhung\""},
    {"solid.floor", "the groove's floor folds: it is bent more sharply than half a cable", "a smaller cable.diameter_mm"},
    {"solid.run_out", "the end of the helical groove has no room to run out", "the change that the message names"},
    {"solid.turns", "the land between two turns of the groove is thinner than the rib", "a greater path.pitch_mm or guide.z_mm"},
    {"solid.validity", "the solid is not closed, or its faces intersect", "a greater pitch, or another groove"},
    {"toolpath.bore", "the flat end mill is too wide to mill the bore", "a smaller machining.tool_diameter_mm"},
    {"toolpath.chip_load", "the cutter rubs: each tooth takes too little",
     "a greater machining.feed_mm_per_min or machining.wrap_feed_mm_per_min"},
    {"toolpath.dowels", "no two dowel pins fit between bore and groove: shaft and key align the half plates",
     "a smaller machining.dowel_diameter_mm"},
    {"toolpath.index", "no pin fits into the blank's upper face: the rotary axis is set by hand to the outline",
     "a smaller machining.dowel_diameter_mm"},
    {"toolpath.process", "G-code is written for a part that some milling rules refuse",
     "fusee check PROFILE --process mill lists them; or outputs.formats without \"ngc\""},
};

constexpr Row kSearchLimits[] = {
    {"cover.greatest", "the springs must reach the upper edge of the dead-band at the greatest co-contraction",
     "a smaller rig.overdrive_torque_Nm, or a greater upper end of co_design.loads_Nm"},
    {"cover.least", "the springs must reach the lower edge of the dead-band at the least co-contraction",
     "a greater rig.least_torque_Nm, or a smaller lower end of co_design.loads_Nm"},
    {"demand.covered_share", "the share of built joints whose springs cover the whole dead-band", "a smaller co_design.covered_share"},
    {"demand.loads_high", "the greatest load that the springs carry", "co_design.loads_Nm"},
    {"demand.loads_low", "the least load that the springs carry", "co_design.loads_Nm"},
    {"demand.soft", "the joint's stiffness at the least load", "a greater co_design.soft_Nm_per_rad"},
    {"demand.stiff", "the joint's stiffness at the greatest load", "a smaller co_design.stiff_Nm_per_rad"},
    {"demand.travel", "the angle over which the springs work", "a smaller co_design.travel_rad"},
    {"limit.contour_radius", "the largest radius of a contour", "a greater co_design.contour_radius_mm"},
    {"limit.rho", "the smallest radius of curvature of a contour", "a smaller co_design.least_rho_se_mm or co_design.least_rho_pe_mm"},
    {"limit.size", "the diameter of a cam, of capstan or joint's pulley", "a greater --size of fusee init, or a smaller --ratio"},
    {"limit.wrap", "the angle over which the cable lies on a planar cam: less than a turn", "path.kind = \"helix\", or a smaller travel"},
    {"design.feasible", "no candidate (k, u, C) of Algorithm 1 gives both springs a stiffness above 0",
     "smaller ranges of algorithm_1.u_Nm and algorithm_1.c_Nm"},
    {"design.weight", "vanishing springs would cost less than the best ones: the weight W2 is too small",
     "a greater algorithm_1.weight_dead_band_per_rad"},
    {"init.energy", "no spring that can be wound holds the work of the law and a preload", "a smaller torque or range"},
    {"search.value", "the nearest candidate of a family has a value that is not allowed", "the key that the message names"},
    {"init.spring", "no spring of this rate can be wound for these loads", "another torque, ratio or range of fusee init"},
};

constexpr Row kRigFaults[] = {
    {"outside.gear_ripple", "one bad tooth: gear friction rises and falls with the angle"},
    {"outside.friction_drift", "the grease warms: friction changes over the session"},
    {"outside.crosstalk", "the other motor's current leaks into this one's command"},
    {"outside.cogging", "the motor's magnets pull it to some angles"},
    {"outside.groove_jump", "the cable leaves its groove for the next one"},
    {"outside.encoder_eccentricity", "the encoder's disc sits off its centre"},
    {"outside.capstan_slip", "the cable slips on its capstan above a tension"},
    {"outside.se_crack", "a cracked K_SE: from one angle on its groove lies lower"},
    {"outside.pe_crack", "a cracked K_PE: from one angle on its groove lies lower"},
    {"outside.pe_creep", "a printed spring creeps: its torque relaxes"},
    {"outside.harness", "the wires to the hand are a spring from the joint to the ground"},
    {"outside.joint_rough_spot", "a dent in the joint's bearing: friction at one angle"},
    {"outside.eccentric_pulley", "the joint's pulley turns about a point off its centre"},
    {"outside.joint_flexibility", "the link bends between encoder and torque"},
    {"outside.clock_skew", "the joint's channel of the log is late"},
    {"outside.encoder_scale", "the joint's encoder counts too many or too few"},
    {"outside.motor_fade", "the motor warms: its torque fades over the session"},
    {"outside.thermal_spring", "K_SE warms: its torque falls over the session"},
    {"outside.magnetic_saturation", "the motor's iron saturates: great currents give less torque"},
    {"outside.friction_rise", "gear friction of the load rises with the speed"},
    {"outside.zero_drift", "the zero of the joint's encoder drifts over the session"},
    {"outside.joint_encoder_eccentricity", "the disc of the joint's encoder sits off its centre"},
    {"outside.quadratic_drag", "the air's drag on the link grows with the square of its speed"},
    {"outside.mount", "the plate that holds motors and joint gives way to both cables"},
};

}  // namespace

std::vector<NamedFinding> named_findings() {
    std::vector<NamedFinding> all;
    const auto add = [&all](const char* kind, std::span<const Row> rows) {
        for (const auto& [id, meaning, remedy] : rows) all.push_back({kind, id, meaning, remedy});
    };
    add("finding of a step", kStepFindings);
    add("limit of a search", kSearchLimits);
    add("fault of the benchmark", kRigFaults);
    for (const std::string_view id : report::subsystem_effects()) all.push_back({"effect of a subsystem case", id, "", ""});
    return all;
}

Entry finding_entry(const NamedFinding& finding) {
    const std::string id(finding.id), meaning = finding.meaning.empty() ? report::meaning(id) : std::string(finding.meaning);
    Entry entry{finding.kind, id, {{"means", meaning}}, {{"kind", finding.kind}, {"name", id}, {"meaning", meaning}}};
    if (finding.remedy.empty()) return entry;
    entry.json["remedy"] = finding.remedy;
    entry.lines.emplace_back("what to change", std::string(finding.remedy));
    return entry;
}

}  // namespace fusee::app
