#pragma once
#include <memory>
#include <random>

#include "fusee/effects/joint.h"
#include "fusee/effects/term.h"
#include "fusee/inference/fit.h"
#include "gap_case/fixture.h"

namespace fusee::fixtures {

inline const effects::Cause kCoulomb{"gear.coulomb", "agonist"}, kOtherCoulomb{"gear.coulomb", "antagonist"};
inline const effects::Cause kLoad{"gear.load_friction", "agonist"}, kStop{"joint.stop", "none"}, kStretch{"cable.stretch", "agonist"};
inline const effects::Cause kRate{"se.rate", "agonist"}, kOtherRate{"se.rate", "antagonist"};
inline const effects::Cause kDrag{"gear.viscous", "both"}, kJointDrag{"joint.viscous", "none"};

/// The small rig as a case of some of its set points.
inline gap_case::Case small_case(const gap_case::Rows& rows) {
    const gap_case::CaseTemplate t = small_template();
    gap_case::Case gap_case;
    gap_case.name = t.name;
    gap_case.rig = t.rig;
    gap_case.tolerance = t.tolerance;
    gap_case.sensors = t.sensors;
    gap_case.protocol = t.protocol;
    gap_case.rows = rows;
    return gap_case;
}

/// The size with the further parameters at their start.
inline std::vector<double> values_at(const effects::Cause& cause, double size) {
    const effects::Effect& effect = effects::find_effect_or_term(cause.id);
    std::vector<double> values{size};
    for (std::size_t k = 1; k < effect.parameters.size(); ++k) values.push_back(effect.parameters[k].at_first);
    return values;
}

/// What a rig shows that has `causes` at `sizes` (in their units), with `noise` times the sensors' noise.
inline gap_case::Case measured_case(const gap_case::Rows& set_points, const inference::Causes& causes, const std::vector<double>& sizes,
                                    double noise, unsigned seed) {
    gap_case::Case gap_case = small_case(set_points);
    joint_model::BuiltRig rig(gap_case.rig);
    rig.joint_coulomb = gap_case.tolerance.joint_coulomb;
    for (std::size_t i = 0; i < causes.size(); ++i)
        effects::apply_effect(effects::find_effect_or_term(causes[i].id), causes[i], values_at(causes[i], sizes[i]), rig);
    rig.assemble(joint_model::NominalCams(gap_case.rig));
    joint_model::Signals signals = joint_model::predict_signals(rig, gap_case.rows, gap_case.protocol);
    gap_case.rows = joint_model::with_measured(gap_case.rows, signals);
    const joint_model::Uncertainty known = joint_model::uncertainty(gap_case);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, noise);
    for (std::size_t e = 0; e < gap_case::kExperiments; ++e)
        for (std::size_t i = 0; i < signals.of[e].size(); ++i) signals.of[e][i] += normal(random) * known.sensors.of[e][i];
    gap_case.rows = joint_model::with_measured(gap_case.rows, signals);
    return gap_case;
}

/// Break-aways of both sides at each torque, `repeats` times, driven back only or both ways.
inline gap_case::Rows break_aways(const std::vector<double>& torques, int repeats, bool both_ways) {
    gap_case::Rows rows;
    for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist})
        for (const bool back : {true, false})
            for (const double torque : torques)
                for (int i = 0; i < repeats; ++i)
                    if (back || both_ways) rows.breakaway.push_back({to_string(side), back, torque, 0.0});
    return rows;
}

/// Every `n`-th of a template's pulls of all springs.
inline gap_case::Rows pulls(std::size_t n) {
    gap_case::Rows rows;
    const std::vector<gap_case::SpringPull> all = set_points(small_template()).spring_pull;
    for (std::size_t i = 0; i < all.size(); i += n) rows.spring_pull.push_back(all[i]);
    return rows;
}

/// The first `seconds` of a template's log: the motors against each other.
inline gap_case::Rows short_log(double seconds) {
    gap_case::Rows rows;
    for (const gap_case::LogRow& row : set_points(small_template()).log)
        if (row.time < seconds) rows.log.push_back(row);
    return rows;
}

struct JointMember {
    explicit JointMember(const gap_case::Case& gap_case) : joint(gap_case) {}
    effects::Joint joint;
};
/// The joint of a gap case, prepared for fits.
struct JointProblem : JointMember, inference::Problem {
    explicit JointProblem(const gap_case::Case& gap_case) : JointMember(gap_case), inference::Problem(joint) {}
    [[nodiscard]] const gap_case::Case& gap_case() const { return joint.gap_case(); }
};

/// Place of an experiment of the joint in the engine.
inline std::size_t place_of(gap_case::Experiment experiment) { return static_cast<std::size_t>(experiment); }

inline inference::Fit best_fit(const inference::Problem& problem, const inference::Causes& causes) {
    return fit(problem, causes, problem.start(causes));
}

}  // namespace fusee::fixtures
