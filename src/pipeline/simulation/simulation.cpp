#include "fusee/pipeline/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fusee/actuator/equilibrium.h"
#include "fusee/actuator/noise.h"
#include "fusee/design/robust.h"
#include "fusee/pipeline/budget.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/spring/potential.h"

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

constexpr std::size_t kBreakAwayRows = 41;

actuator::ArrangementOptions arrangement_of(const ResolvedDesign& design) {
    const profile::Rig& rig = design.profile.rig;
    return {.arrangement = rig.arrangement,
            .series = spring::series_spring(design.law()),
            .parallel = spring::parallel_spring(design.law()),
            .gear_friction = design.actuator.gear_friction,
            .capstan_radius = rig.capstan_radius,
            .joint_radius = rig.joint_radius,
            .position_stiffness = rig.position_stiffness,
            .cross_stretch = rig.cross_stretch};
}

/// Levels of co-contraction from least to overdrive torque, both included.
std::vector<double> torques(const profile::Rig& rig, int levels) {
    std::vector<double> all;
    for (int i = 0; i < levels; ++i)
        all.push_back(i + 1 == levels ? rig.overdrive_torque
                                      : rig.least_torque + (rig.overdrive_torque - rig.least_torque) * i / (levels - 1));
    return all;
}

/// The width that a test with a given push measures [rad].
double measure(const actuator::Joint& joint, double tau, double push_torque) {
    return actuator::release_test(joint, tau, {.push_torque = push_torque, .find_full_push = false}).width();
}

/// Reasons why figures are unknown, each once.
class Gaps {
public:
    void note(const std::string& what, const core::Findings& refusal) {
        for (const core::Finding& finding : refusal) notes_.insert(fmt::format("{}: {}", what, core::to_line(finding)));
    }
    [[nodiscard]] std::vector<std::string> list() const { return {notes_.begin(), notes_.end()}; }

private:
    std::set<std::string> notes_;
};

/// A joint of the paper's kind, simulated as a whole.
class JointSimulator {
public:
    JointSimulator(const ResolvedDesign& design, double push_torque)
        : profile_(design.profile),
          actuator_(design.actuator),
          joint_(joint_of(design)),
          path_joint_(path_joint_of(design)),
          frame_(path_joint_of(design, false)),
          test_{.push_torque = push_torque} {
        if (profile_.has_parts) drawn_ = design.drawn_joint(), scatter_ = shop_scatter(profile_);
    }

    void fill(Simulation& simulation, const std::vector<double>& levels) {
        for (const double tau : levels) simulation.levels.push_back(level(tau));
        simulation.condition = actuator::summarize_condition(actuator_);
        simulation.measured = measured();
        const double peak = actuator_.peak_torque;
        if (const actuator::ReleaseReading at_peak = actuator::release_test(path_joint_, peak, test_); at_peak.push_torque > 0.0)
            simulation.path = release_path(path_joint_, peak, at_peak.push_torque);
        for (const std::size_t i : std::set{std::size_t{0}, levels.size() / 2, levels.size() - 1})
            if (const double push = simulation.levels[i].reading.push_torque; push > 0.0)
                simulation.loops.push_back(deflection_loop(path_joint_, levels[i], push));
        simulation.break_away = break_away_rows(actuator_.gear_friction, actuator_.overdrive_torque, kBreakAwayRows);
        simulation.gaps = gaps_.list();
    }

private:
    SimulatedLevel level(double tau) {
        SimulatedLevel level = simulate_level(actuator_, path_joint_, tau, test_);
        if (level.reading.push_torque > 0.0) level.frame = measure(frame_, tau, level.reading.push_torque);
        if (const double theta = level.dead_band.theta; std::isfinite(theta)) {
            if (const auto matrix = actuator::sensitivity(joint_, {theta, theta, 0.0}))
                level.sensitivity = *matrix;
            else
                gaps_.note("sensitivity", matrix.refusal());
        }
        if (const auto noise = actuator::joint_noise(joint_, tau, profile_.dynamics))
            level.noise = *noise;
        else
            gaps_.note("noise", noise.refusal());
        if (drawn_) level.built = fusee::design::robust_dead_band(*drawn_, tau, scatter_).band;
        return level;
    }
    [[nodiscard]] std::vector<MeasuredRow> measured() const {
        const profile::Rows& table = profile_.simulate.measured;
        std::vector<MeasuredRow> rows;
        for (std::size_t i = 0; i < table.x.size(); ++i)
            rows.push_back({table.x[i], table.y[i], simulate_level(actuator_, path_joint_, table.x[i], test_).dead_band});
        return rows;
    }

    const profile::Profile& profile_;
    const actuator::Actuator& actuator_;
    actuator::Joint joint_, path_joint_, frame_;
    actuator::ReleaseTest test_;
    std::optional<fusee::design::DrawnJoint> drawn_;  ///< if there are parts
    fusee::design::ShopScatter scatter_;              ///< of their process and of [budget]
    Gaps gaps_;
};

/// The paper's joint is compared over the co-contractions that its law reaches; its relatives must reach all (else survey refuses).
actuator::ArrangementRow survey_of(const actuator::ArrangementOptions& options, const profile::Rig& rig, const core::Range& loads) {
    core::Range torques{rig.least_torque, rig.overdrive_torque};
    if (options.arrangement == actuator::Arrangement::kPnrvsa) {
        constexpr double kInside = 1e-9;  // rounding must not leave the law
        torques = {std::max(torques.low, (1.0 + kInside) * loads.low), std::min(torques.high, (1.0 - kInside) * loads.high)};
        if (torques.width() < 0.0) return unknown_survey();
    }
    return actuator::survey(options, torques);
}

/// The torques of the equilibria asked for, for the stamp.
std::string at_text(const std::vector<Eigen::Vector3d>& at) {
    std::string text;
    for (const Eigen::Vector3d& torque : at) text += fmt::format(", at={},{},{}", torque[0], torque[1], torque[2]);
    return text;
}

/// The figures of one level that the comparison of relatives needs.
SimulatedLevel surveyed_level(const actuator::ArrangementOptions& options, double tau) {
    const actuator::ArrangementRow row = actuator::survey(options, {tau, tau});
    SimulatedLevel level = unknown_level(tau);
    level.dead_band.linear = row.dead_band.low;
    level.dead_band.joint_stiffness = row.stiffness.low;
    level.dead_band.free_joint_stiffness = row.free_stiffness.low;
    return level;
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

actuator::Joint joint_of(const ResolvedDesign& design) {
    actuator::Joint joint = actuator::joint_of(design.actuator);
    joint.output_friction = design.profile.rig.joint_friction;
    return joint;
}

actuator::Joint path_joint_of(const ResolvedDesign& design, bool gears) {
    const auto series = spring::resampled(spring::series_spring(design.law())),
               parallel = spring::resampled(spring::parallel_spring(design.law()));
    const spring::FrictionLaw gear = gears ? design.actuator.gear_friction : spring::FrictionLaw::proportional(0.0);
    const profile::Rig& rig = design.profile.rig;
    actuator::Joint joint = actuator::antagonist(parallel, series, series, parallel, {gear, gear}, rig.capstan_radius, rig.joint_radius);
    joint.output_friction = rig.joint_friction;
    return joint;
}

SimulatedLevel simulate_level(const actuator::Actuator& actuator, const actuator::Joint& joint, double tau,
                              const actuator::ReleaseTest& test) {
    SimulatedLevel level = unknown_level(tau);
    level.reading = actuator::release_test(joint, tau, test);
    level.dead_band = {actuator::dead_band(actuator, tau), level.reading.width()};
    if (level.reading.covered_push > 0.0)
        level.within_laws = level.reading.inside ? level.reading.width() : measure(joint, tau, level.reading.covered_push);
    return level;
}

Simulation simulate(const ResolvedDesign& design, const SimulateOptions& options) {
    const profile::Profile& profile = design.profile;
    const profile::Rig& rig = profile.rig;
    const bool paper_joint = rig.arrangement == actuator::Arrangement::kPnrvsa;
    const actuator::ArrangementOptions arrangement = arrangement_of(design);
    const int count = options.levels > 0 ? options.levels : profile.simulate.levels;
    const double push = options.push_torque.value_or(profile.simulate.push_torque);
    const std::vector<double> levels = torques(rig, count);

    Simulation simulation;
    simulation.provenance = {profile.name, profile.sha256, fmt::format("levels={}, push_torque_Nm={}{}", count, push, at_text(options.at))};
    simulation.survey = survey_of(arrangement, rig, design.law()->loads());
    simulation.push_torque = push;
    simulation.bearing = rig.joint_friction;
    if (paper_joint) {
        simulation.findings = design.findings;
        JointSimulator(design, push).fill(simulation, levels);
        simulation.stretches = stretch_sides(design);
        simulation.wraps = wrap_sides(design);
        const bool cables_known = profile.wrap.friction > 0.0 && profile.wrap.stiffness > 0.0;
        if (profile.has_parts && !cables_known)
            simulation.gaps.push_back("hysteresis of the cables on their cams: state cable.friction and cable.stiffness_N");
    } else {
        for (const double tau : levels) simulation.levels.push_back(surveyed_level(arrangement, tau));
    }
    if (!options.at.empty()) {
        const actuator::Joint joint = paper_joint ? joint_of(design) : actuator::make_arrangement(arrangement);
        for (const Eigen::Vector3d& torque : options.at) simulation.equilibria.push_back(equilibrium_at(joint, torque));
    }
    return simulation;
}

Simulation headline_simulation(const ResolvedDesign& design) {
    Simulation simulation;
    simulation.survey = survey_of(arrangement_of(design), design.profile.rig, design.law()->loads());
    simulation.condition = actuator::summarize_condition(design.actuator);
    simulation.findings = design.findings;
    return simulation;
}

core::Outcome<Simulation> simulate(const profile::Profile& profile, const SimulateOptions& options) {
    require_joint(profile, "a simulation");
    const auto design = resolve(profile);
    if (!design) return design.refusal();
    return simulate(*design, options);
}

}  // namespace fusee::pipeline
