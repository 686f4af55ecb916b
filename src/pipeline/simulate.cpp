#include "fusee/pipeline/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/equilibrium.h"
#include "fusee/actuator/noise.h"
#include "fusee/actuator/relatives.h"
#include "fusee/core/destination.h"
#include "fusee/core/file.h"
#include "fusee/design/robust.h"
#include "fusee/pipeline/export.h"
#include "fusee/spring/cable.h"
#include "fusee/spring/resampled.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

constexpr std::size_t kBreakAwayRows = 41;

actuator::ArrangementOptions arrangement_of(const profile::Profile& profile, const spring::SpringLawPtr& law) {
    return {.arrangement = profile.rig.arrangement,
            .series = spring::series_spring(law),
            .parallel = spring::parallel_spring(law),
            .gear_friction = gear_friction(profile),
            .capstan_radius = profile.rig.capstan_radius,
            .joint_radius = profile.rig.joint_radius,
            .position_stiffness = profile.rig.position_stiffness,
            .cross_stretch = profile.rig.cross_stretch};
}

/// Levels of co-contraction from least to overdrive torque, both included.
std::vector<double> torques(const profile::Rig& rig, int levels) {
    std::vector<double> all;
    for (int i = 0; i < levels; ++i)
        all.push_back(i + 1 == levels ? rig.overdrive_torque
                                      : rig.least_torque + (rig.overdrive_torque - rig.least_torque) * i / (levels - 1));
    return all;
}

/// What a test with a given push reads [rad].
double read(const actuator::Joint& joint, double tau, double push_torque) {
    return actuator::release_test(joint, tau, {.push_torque = push_torque, .find_full_push = false}).width();
}

/// Reasons why something is not known, each once.
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
    JointSimulator(const profile::Profile& profile, const spring::SpringLawPtr& law, double push_torque)
        : profile_(profile),
          actuator_(actuator_of(profile, law)),
          joint_(joint_of(profile, law)),
          path_joint_(path_joint_of(profile, law)),
          frame_(path_joint_of(profile, law, false)),
          test_{.push_torque = push_torque} {
        if (profile.has_parts) drawing_ = drawing_of(profile, law);
    }

    void fill(report::Simulation& simulation, const std::vector<double>& levels) {
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
    report::SimulatedLevel level(double tau) {
        report::SimulatedLevel level = simulate_level(actuator_, path_joint_, tau, test_);
        if (level.reading.push_torque > 0.0) level.frame = read(frame_, tau, level.reading.push_torque);
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
        if (drawing_) level.built = design::robust_dead_band(*drawing_, tau).band;
        return level;
    }
    [[nodiscard]] std::vector<report::MeasuredRow> measured() const {
        const profile::Rows& table = profile_.simulate.measured;
        std::vector<report::MeasuredRow> rows;
        for (std::size_t i = 0; i < table.x.size(); ++i)
            rows.push_back({table.x[i], table.y[i], simulate_level(actuator_, path_joint_, table.x[i], test_).dead_band});
        return rows;
    }

    const profile::Profile& profile_;
    actuator::Actuator actuator_;
    actuator::Joint joint_, path_joint_, frame_;
    actuator::ReleaseTest test_;
    std::optional<design::Drawing> drawing_;  ///< where there are parts
    Gaps gaps_;
};

/// The paper's joint is compared over the co-contractions that its law reaches; its relatives have to reach all (survey refuses).
actuator::ArrangementRow survey_of(const actuator::ArrangementOptions& options, const profile::Rig& rig, const core::Range& loads) {
    core::Range torques{rig.least_torque, rig.overdrive_torque};
    if (options.arrangement == actuator::Arrangement::kPnrvsa) {
        constexpr double kInside = 1e-9;  // rounding must not lead out of the law
        torques = {std::max(torques.low, (1.0 + kInside) * loads.low), std::min(torques.high, (1.0 - kInside) * loads.high)};
        if (torques.width() < 0.0) return report::unknown_survey();
    }
    return actuator::survey(options, torques);
}

/// The torques that equilibria are asked for, as a stamp shows them.
std::string at_text(const std::vector<Eigen::Vector3d>& at) {
    std::string text;
    for (const Eigen::Vector3d& torque : at) text += fmt::format(", at={},{},{}", torque[0], torque[1], torque[2]);
    return text;
}

/// What the table of relatives knows of one level.
report::SimulatedLevel surveyed_level(const actuator::ArrangementOptions& options, double tau) {
    const actuator::ArrangementRow row = actuator::survey(options, {tau, tau});
    report::SimulatedLevel level = report::unknown_level(tau);
    level.dead_band.linear = row.dead_band.low;
    level.dead_band.joint_stiffness = row.stiffness.low;
    level.dead_band.free_joint_stiffness = row.free_stiffness.low;
    return level;
}

}  // namespace

actuator::Joint joint_of(const profile::Profile& profile, const spring::SpringLawPtr& law) {
    actuator::Joint joint = actuator::joint_of(actuator_of(profile, law));
    joint.output_friction = profile.rig.joint_friction;
    return joint;
}

actuator::Joint path_joint_of(const profile::Profile& profile, const spring::SpringLawPtr& law, bool gears) {
    const auto series = spring::resampled(spring::series_spring(law)), parallel = spring::resampled(spring::parallel_spring(law));
    const friction::Law gear = gears ? gear_friction(profile) : friction::Law::proportional(0.0);
    actuator::Joint joint =
        actuator::antagonist(parallel, series, series, parallel, {gear, gear}, profile.rig.capstan_radius, profile.rig.joint_radius);
    joint.output_friction = profile.rig.joint_friction;
    return joint;
}

report::SimulatedLevel simulate_level(const actuator::Actuator& actuator, const actuator::Joint& joint, double tau,
                                      const actuator::ReleaseTest& test) {
    report::SimulatedLevel level = report::unknown_level(tau);
    level.dead_band = actuator::dead_band(actuator, tau);
    level.reading = actuator::release_test(joint, tau, test);
    level.dead_band.measured_width = level.reading.width();
    if (level.reading.covered_push > 0.0)
        level.within_laws = level.reading.inside ? level.reading.width() : read(joint, tau, level.reading.covered_push);
    return level;
}

core::Outcome<report::Simulation> simulate(const profile::Profile& profile, const SimulateOptions& options) {
    const auto law = design_law(profile);
    if (!law) return law.refusal();
    const profile::Rig& rig = profile.rig;
    const actuator::ArrangementOptions arrangement = arrangement_of(profile, law->law);
    const int count = options.levels > 0 ? options.levels : profile.simulate.levels;
    const double push = options.push_torque.value_or(profile.simulate.push_torque);
    const std::vector<double> levels = torques(rig, count);

    report::Simulation simulation;
    simulation.provenance = {profile.name, profile.sha256, fmt::format("levels={}, push_torque_Nm={}{}", count, push, at_text(options.at))};
    simulation.survey = survey_of(arrangement, rig, law->law->loads());
    simulation.push_torque = push;
    simulation.bearing = rig.joint_friction;
    if (rig.arrangement == actuator::Arrangement::kPnrvsa) {
        simulation.findings = law->findings;
        JointSimulator(profile, law->law, push).fill(simulation, levels);
        simulation.stretches = stretch_sides(profile, law->law);
        simulation.wraps = wrap_sides(profile, law->law);
        const bool cables_known = profile.wrap.friction > 0.0 && profile.wrap.stiffness > 0.0;
        if (profile.has_parts && !cables_known)
            simulation.gaps.push_back("hysteresis of the cables on their cams: cable.friction and cable.stiffness_N are not both stated");
    } else {
        for (const double tau : levels) simulation.levels.push_back(surveyed_level(arrangement, tau));
    }
    if (!options.at.empty()) {
        const bool paper = rig.arrangement == actuator::Arrangement::kPnrvsa;
        const actuator::Joint joint = paper ? joint_of(profile, law->law) : actuator::make_arrangement(arrangement);
        for (const Eigen::Vector3d& torque : options.at) simulation.equilibria.push_back(equilibrium_at(joint, torque));
    }
    return simulation;
}

std::vector<report::FileRow> write_simulation(const report::Simulation& simulation, const fs::path& folder) {
    core::make_folder(folder);
    std::vector<report::FileRow> rows;
    const auto write = [&](const char* name, const std::string& bytes) {
        core::write_file(folder / name, bytes);
        rows.push_back(file_row(folder / name));
    };
    write("simulation.json", report::simulation_json(simulation));
    write("dead_band.csv", report::dead_band_csv(simulation.levels));
    write("simulation.html", report::simulation_html(simulation));
    if (!simulation.wraps.empty()) write("wrap_hysteresis.csv", report::wrap_hysteresis_csv(simulation.wraps));
    return rows;
}

}  // namespace fusee::pipeline
