#include "fusee/pipeline/simulation.h"

#include <fmt/format.h>

#include <Eigen/Core>

#include "fusee/actuator/equilibrium.h"
#include "fusee/cam/wrap_friction.h"
#include "fusee/pipeline/design.h"
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

SimulatedLevel unknown_level(double tau) {
    SimulatedLevel level;
    level.dead_band.tau = level.reading.tau = tau;
    for (double* figure :
         {&level.dead_band.linear, &level.dead_band.exact_width, &level.dead_band.measured_width, &level.dead_band.joint_stiffness,
          &level.dead_band.free_joint_stiffness, &level.dead_band.theta, &level.dead_band.condition_6, &level.reading.push_torque,
          &level.reading.full_push, &level.reading.covered_push, &level.reading.q_low, &level.reading.q_high})
        *figure = kUnknown;
    level.dead_band.covered = level.reading.inside = false;
    level.sensitivity.setConstant(kUnknown);
    level.noise.setConstant(kUnknown);
    return level;
}

actuator::ArrangementRow unknown_survey() {
    constexpr core::Range kNone{kUnknown, kUnknown};
    return {.stiffness = kNone, .free_stiffness = kNone, .torque = kUnknown, .dead_band = kNone, .remark = ""};
}

core::Findings refusals(const Simulation& simulation) {
    core::Findings all;
    for (const EquilibriumRow& row : simulation.equilibria) core::append(all, row.refusal);
    return all;
}

std::vector<StretchSide> stretch_sides(const ResolvedDesign& design) {
    std::vector<StretchSide> sides;
    if (!design.profile.has_parts) return sides;
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const cam::ArmPoint most = design.arm(kind).at_load(design.law()->loads().high);
        if (most.elongation.turn != 0.0) sides.push_back({kind, most});
    }
    return sides;
}

std::vector<WrapSide> wrap_sides(const ResolvedDesign& design) {
    std::vector<WrapSide> sides;
    const cam::WrapFriction& wrap = design.profile.wrap;
    if (!design.profile.has_parts || wrap.friction <= 0.0 || wrap.stiffness <= 0.0) return sides;
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const auto cam = design_cam(kind, design);
        if (!cam || cam->has_roller()) continue;  // `make` says why there is no cam
        const profile::PartSpec& spec = design.spec(kind);
        const double rate = spring::in_series_with_cable(spec.spring, spec.allowance.cable_compliance).rate;
        sides.push_back({kind, cam::wrap_loop(*cam, rate, design.profile.rig.capstan_radius, wrap)});
    }
    return sides;
}

EquilibriumRow equilibrium_at(const actuator::Joint& joint, const Eigen::Vector3d& torque) {
    EquilibriumRow row{.torque = torque};
    const auto rest = actuator::find_equilibrium(joint, torque);
    if (!rest) {
        row.refusal = rest.refusal();
        for (core::Finding& finding : row.refusal) {
            if (!finding.where.empty()) finding.where += ", ";
            finding.where += fmt::format("at {}, {}, {} Nm", torque[0], torque[1], torque[2]);
        }
        return row;
    }
    row.z = rest->z;
    row.sensitivity = actuator::sensitivity(joint, row.z).value();  // springs hold every motion of a joint that rests
    row.cable_space = actuator::cable_space(row.sensitivity, joint);
    row.joint_stiffness = actuator::stiffness(joint, row.z)(actuator::kOutput, actuator::kOutput);
    row.free_joint_stiffness = 1.0 / row.sensitivity(actuator::kOutput, actuator::kOutput);
    if (torque[actuator::kOutput] == 0.0)
        row.dead_band = actuator::joint_dead_band(joint, torque[actuator::kAgonist], torque[actuator::kAntagonist]);
    return row;
}

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
