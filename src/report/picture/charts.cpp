#include "picture/charts.h"

#include "data/figures.h"
#include "page/column.h"

namespace fusee::report {

namespace {

constexpr const char* kCapstanLoad = "capstan load [Nm]";

core::Range lead_in(const LawReport& law) { return {law.samples.front().tau, law.design_loads.low}; }

std::vector<double> cam_angles(const cam::Cam& cam) {
    return column(cam.working, [](const cam::Contact& c) { return deg_from_rad(c.arm.angle); });
}

}  // namespace

Plot law_chart(const LawReport& law) {
    const std::vector<double> theta = column(law.samples, &spring::LawPoint::theta);
    return Plot("Spring torques over the capstan's angle", "capstan angle [rad]", "torque [Nm]")
        .shade({0.0, law.lead_in_travel}, "lead-in")
        .curve("F_SE", theta, column(law.samples, &spring::LawPoint::f_se), "se")
        .curve("F_PE", theta, column(law.samples, &spring::LawPoint::f_pe), "pe")
        .curve("sum", theta, column(law.samples, &spring::LawPoint::tau), "sum", true)
        .from_zero();
}

Plot stiffness_chart(const LawReport& law) {
    const std::vector<double> tau = column(law.samples, &spring::LawPoint::tau);
    return Plot("Stiffness", kCapstanLoad, "stiffness [Nm/rad]")
        .shade(lead_in(law), "lead-in")
        .curve("S", tau, column(law.samples, &spring::LawPoint::s), "se")
        .curve("P", tau, column(law.samples, &spring::LawPoint::p), "pe")
        .from_zero();
}

Plot transmission_chart(const LawReport& law) {
    return Plot("T = S/(S+P): share of stiction that reaches the joint", kCapstanLoad, "T [1]")
        .shade(lead_in(law), "lead-in")
        .curve("T", column(law.samples, &spring::LawPoint::tau), column(law.samples, &spring::LawPoint::transmission), "t")
        .from_zero();
}

Plot dead_band_chart(const std::vector<actuator::DeadBand>& levels) {
    const std::vector<double> tau = column(levels, &actuator::DeadBand::tau);
    return Plot("Dead-band at the joint, edge to edge", kCoContractionAxis, "dead-band [deg]")
        .curve("linear: 2 mu tau / (g P)", tau, column(levels, [](const actuator::DeadBand& d) { return deg_from_rad(d.linear); }),
               "linear", true)
        .curve("exact", tau, column(levels, [](const actuator::DeadBand& d) { return deg_from_rad(d.exact_width); }), "exact")
        .from_zero();
}

Plot joint_stiffness_chart(const std::vector<actuator::DeadBand>& levels) {
    const std::vector<double> tau = column(levels, &actuator::DeadBand::tau);
    return Plot("Stiffness of the joint", kCoContractionAxis, "stiffness [Nm/rad]")
        .curve("capstans held", tau, column(levels, &actuator::DeadBand::joint_stiffness), "se")
        .curve("capstans free", tau, column(levels, &actuator::DeadBand::free_joint_stiffness), "sum", true)
        .from_zero();
}

Plot arm_chart(const cam::Cam& cam) {
    return Plot("Lever arm", "cam angle [deg]", "arm [mm]")
        .curve("arm", cam_angles(cam), column(cam.working, [](const cam::Contact& c) { return core::mm_from_m(c.arm.arm); }),
               cam.kind == cam::PartKind::kSeries ? "se" : "pe");
}

Plot height_chart(const cam::Cam& cam) {
    return Plot("Height of the cable on the helix", "cam angle [deg]", "z [mm]")
        .curve("z", cam_angles(cam), column(cam.working, [](const cam::Contact& c) { return core::mm_from_m(c.path.z); }), "sum");
}

}  // namespace fusee::report
