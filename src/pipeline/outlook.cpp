#include "outlook.h"

#include <algorithm>

#include "fusee/actuator/dead_band.h"
#include "fusee/checks/limits.h"
#include "fusee/design/robust.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::pipeline {

namespace {

report::ExpectedWidth width_at(const design::Drawing& drawing, double tau) {
    report::ExpectedWidth width;
    width.tau = tau;
    width.nominal = actuator::dead_band(drawing.actuator, tau).exact_width;
    width.built = design::robust_dead_band(drawing, tau).band;
    return width;
}

report::MadeArm made_arm(const report::PartReport& report, double tolerance_mm) {
    const std::vector<cam::Contact>& working = report.part->cam.working;
    const auto least = std::min_element(working.begin(), working.end(), [](const auto& a, const auto& b) { return a.arm.arm < b.arm.arm; });
    return {cam::to_string(report.part->cam.kind), tolerance_mm, core::mm_from_m(least->arm.arm)};
}

}  // namespace

report::Outlook outlook_of(const profile::Profile& profile, const spring::SpringLawPtr& law, const report::Simulation& simulation,
                           const std::vector<report::PartReport>& parts) {
    const design::Drawing drawing = drawing_of(profile, law);
    report::Outlook outlook;
    outlook.process = checks::to_string(profile.process.kind);
    for (const report::PartReport& part : parts)
        outlook.arms.push_back(made_arm(part, core::mm_from_m(checks::process_limits(profile.process).tolerance)));
    outlook.least = width_at(drawing, profile.rig.least_torque);
    outlook.overdrive = width_at(drawing, profile.rig.overdrive_torque);
    outlook.joint_torque = simulation.survey.torque;
    outlook.condition = simulation.condition;
    return outlook;
}

}  // namespace fusee::pipeline
