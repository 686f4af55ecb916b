#include <Eigen/Core>

#include "fusee/pipeline/simulate.h"

namespace fusee::pipeline {

namespace {

using actuator::StickSlip;

constexpr int kPathSteps = 80;  // of each stroke, for a picture
constexpr int kCycles = 3;      // a rate-independent path with constant torques repeats from the second cycle on

/// Changes the joint's torque to `torque` in steps and records each.
void lead(StickSlip& joint, double torque, std::vector<PathPoint>& path) {
    const Eigen::Vector3d from = joint.torque();
    const auto note = [&] {
        const Eigen::Vector3d loads = actuator::spring_torques(joint.joint(), joint.z());
        path.push_back(
            {joint.torque()[actuator::kOutput], joint.z()[actuator::kOutput], loads[actuator::kAgonist], loads[actuator::kAntagonist]});
    };
    if (path.empty()) note();
    for (int i = 1; i <= kPathSteps; ++i) {
        Eigen::Vector3d next = from;
        next[actuator::kOutput] += (torque - from[actuator::kOutput]) * i / kPathSteps;
        joint.lead_to(next, 1);
        note();
    }
}

StickSlip co_contracted(const actuator::Joint& joint, double tau) {
    StickSlip path(joint);
    path.lead_to({tau, tau, 0.0});
    return path;
}

}  // namespace

ReleasePath release_path(const actuator::Joint& joint, double tau, double push_torque) {
    StickSlip stick_slip = co_contracted(joint, tau);
    ReleasePath path{tau, joint.gear_friction[0].resting_loads(tau), {}, {}};
    lead(stick_slip, push_torque, path.up);
    lead(stick_slip, 0.0, path.up);
    lead(stick_slip, -push_torque, path.down);
    lead(stick_slip, 0.0, path.down);
    return path;
}

DeflectionLoop deflection_loop(const actuator::Joint& joint, double tau, double torque) {
    StickSlip stick_slip = co_contracted(joint, tau);
    DeflectionLoop loop{tau, {}};
    for (int cycle = 0; cycle < kCycles; ++cycle) {
        loop.cycle.clear();
        lead(stick_slip, torque, loop.cycle);
        loop.cycle.clear();
        lead(stick_slip, -torque, loop.cycle);
        lead(stick_slip, torque, loop.cycle);
    }
    return loop;
}

std::vector<BreakAwayRow> break_away_rows(const spring::FrictionLaw& gear, double greatest, std::size_t count) {
    std::vector<BreakAwayRow> rows;
    for (std::size_t i = 0; i < count; ++i) {
        const double torque = greatest * static_cast<double>(i) / static_cast<double>(count - 1);
        rows.push_back({torque, gear.resting_loads(torque)});
    }
    return rows;
}

}  // namespace fusee::pipeline
