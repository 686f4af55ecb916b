#include "fusee/assembly/motion.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

using Eigen::Vector3d;

const Vector3d kUp(0.0, 0.0, 1.0), kDown(0.0, 0.0, -1.0), kAway(0.0, 1.0, 0.0), kTowards(0.0, -1.0, 0.0);

/// What is put together on the carriage, without the rods: its bodies in their order.
std::vector<Step> carriage_steps(const Assembly& a) {
    const bool through = has_through_axle(*a.drive.k_se), spring = a.find("k_se_spring_agonist") != nullptr;
    std::vector<Step> steps{{"carriage", {{"carriage"}}, Vector3d::Zero(), ""},
                            {"carriage", {{"bushes"}}, kAway, "pressed into the housings from both ends"},
                            {"carriage", {{"axle_sleeve"}}, kUp, "pressed into the plate"},
                            {"carriage", {{"axle_rings", 1}}, kDown, "the support washers, over the sleeve"},
                            {"carriage", {{"k_se"}}, kDown, "at its timing mark"}};
    steps.push_back({"carriage",
                     {{"axle"}},
                     kUp,
                     through ? "through sleeve, washers and spool" : "through the sleeve; bond it into the spool's blind bore"});
    steps.push_back({"carriage", {{"axle_rings", 0}}, kUp, "the retaining ring below the sleeve, snapped on from the side"});
    if (a.find("spring_arbor_agonist") != nullptr) steps.push_back({"carriage", {{"spring_arbor"}}, kDown, "on the axle"});
    if (spring) {
        Step legs{"carriage",
                  {{"k_se_spring"}, {"leg_in_carriage"}},
                  kDown,
                  "its axial leg into the slot of k_se, its radial one into that of the post"};
        if (a.find("leg_in_k_se_agonist") != nullptr) legs.pieces.push_back({"leg_in_k_se"});
        steps.push_back(std::move(legs));
    }
    if (through) steps.push_back({"carriage", {{"axle_rings", 2}}, kDown, "the upper retaining ring, snapped on from the side"});
    return steps;
}

/// A subassembly's bodies as one: all that its steps have put together.
std::vector<Piece> pieces_of(const std::vector<Step>& steps, const std::string& subassembly) {
    std::vector<Piece> all;
    for (const Step& step : steps)
        if (step.subassembly == subassembly) all.insert(all.end(), step.pieces.begin(), step.pieces.end());
    return all;
}

}  // namespace

// Rings of the body "bearings": tower, plate at the joint, then arm and plate at each motor.
std::vector<Step> assembly_steps(const Assembly& a) {
    if (a.find("frame_plate") == nullptr || has_bridge(a.drive)) return {};
    std::vector<Step> steps = carriage_steps(a);
    steps.push_back({"frame_rear", {{"frame_rear"}}, Vector3d::Zero(), ""});
    steps.push_back({"frame_rear", {{"bearings", 2}, {"bearings", 4}}, kUp, "pressed into both arms"});
    steps.push_back({"joint_tower", {{"joint_tower"}}, Vector3d::Zero(), ""});
    steps.push_back({"joint_tower", {{"bearings", 0}}, kDown, "pressed in, down to its shoulder"});
    steps.push_back(
        {"joint_tower", {{"joint_stops"}}, kUp, a.find("joint_stops")->prisms.size() == 1 ? "pressed in" : "both stop posts, pressed in"});
    steps.push_back({"", {{"frame_plate"}}, Vector3d::Zero(), "lies on its upper face"});
    steps.push_back({"", {{"bearings", 1}, {"bearings", 3}, {"bearings", 5}}, kUp, "pressed in, flush with the lower face"});
    const std::vector<Step> subassemblies = steps;
    steps.push_back({"", pieces_of(subassemblies, "joint_tower"), kUp, "three frame screws"});
    steps.push_back({"", pieces_of(subassemblies, "frame_rear"), kUp, "four frame screws"});
    steps.push_back({"", {{"frame_front"}}, kUp, "four frame screws"});
    steps.push_back({"", pieces_of(subassemblies, "carriage"), kUp, "the agonist's first, between the brackets"});
    steps.push_back(
        {"", {{"rods"}}, kTowards, "through frame_front, the closed bushes and frame_rear; a screw with a washer in both ends of each"});
    std::vector<Piece> pulley{{"joint_pulley"}};
    if (a.find("stop_pin") != nullptr) pulley.push_back({"stop_pin"});
    steps.push_back({"", std::move(pulley), kUp, "its pin, pressed in before, between the stop posts"});
    steps.push_back({"", {{"joint_shaft"}}, kDown, "through both bearings and the pulley, which it is locked to"});
    const bool stopped = a.find("capstan_pin_agonist") != nullptr;
    std::vector<Piece> capstan{{"capstan"}};
    if (stopped) capstan.push_back({"capstan_pin"});
    steps.push_back(
        {"", std::move(capstan), kAway, stopped ? "its pin, pressed in before, below; between arm and plate" : "between arm and plate"});
    steps.push_back({"", {{"shaft_collar"}}, kAway, "beside the capstan"});
    steps.push_back(
        {"", {{"motor_shaft"}}, kDown, "through bearing, collar, capstan and bearing; lock the capstan and tighten the collar"});
    if (stopped) steps.push_back({"", {{"capstan_stops"}}, kUp, "the posts beside its pin, pressed through the arm"});
    steps.push_back(
        {"",
         {{"k_pe"}},
         kUp,
         a.drive.k_pe->options.hub.kind == solid::HubKind::kOverhung ? "its boss first; bond it to the shaft" : "locked on the shaft"});
    if (a.find("k_pe_posts") == nullptr) return steps;
    steps.push_back({"", {{"k_pe_posts"}}, kUp, "two frame screws each"});
    steps.push_back({"", {{"k_pe_seat"}}, kAway, "two seat screws each"});
    if (a.find("k_pe_spring_agonist") == nullptr) return steps;
    steps.push_back({"", {{"k_pe_spring"}}, kAway, ""});
    steps.push_back({"", {{"k_pe_cap"}}, kAway, ""});
    return steps;
}

}  // namespace fusee::assembly
