#pragma once
#include <memory>
#include <random>

#include "case_fixture.h"
#include "fit.h"

namespace fusee::gap::fixtures {

/// The small rig as a case of some of its set points.
inline Case small_case(const Rows& rows) {
    const CaseTemplate t = small_template();
    Case bench;
    bench.name = t.name;
    bench.rig = t.rig;
    bench.tolerance = t.tolerance;
    bench.sensors = t.sensors;
    bench.protocol = t.protocol;
    bench.rows = rows;
    return bench;
}

/// What a rig shows that has `causes` at `sizes` (in their units), with `noise` times the sensors' noise.
inline Case measured_case(const Rows& set_points, const Causes& causes, const std::vector<double>& sizes, double noise, unsigned seed) {
    Case bench = small_case(set_points);
    BuiltRig rig(bench.rig);
    rig.joint_coulomb = bench.tolerance.joint_coulomb;
    for (std::size_t i = 0; i < causes.size(); ++i) apply_effect(find_effect(causes[i].id), causes[i], std::vector{sizes[i]}, rig);
    rig.assemble(NominalCams(bench.rig));
    Signals signals = predict_signals(rig, bench.rows, bench.protocol);
    bench.rows = with_measured(bench.rows, signals);
    const Uncertainty known = uncertainty(bench);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, noise);
    for (std::size_t e = 0; e < kExperiments; ++e)
        for (std::size_t i = 0; i < signals.of[e].size(); ++i) signals.of[e][i] += normal(random) * known.sensors.of[e][i];
    bench.rows = with_measured(bench.rows, signals);
    return bench;
}

/// Break-aways of both sides at each torque, `repeats` times, driven back only or both ways.
inline Rows break_aways(const std::vector<double>& torques, int repeats, bool both_ways) {
    Rows rows;
    for (const Side side : {Side::kAgonist, Side::kAntagonist})
        for (const bool back : {true, false})
            for (const double torque : torques)
                for (int i = 0; i < repeats; ++i)
                    if (back || both_ways) rows.breakaway.push_back({to_string(side), back, torque, 0.0});
    return rows;
}

/// Every `n`-th of a template's pulls of all springs.
inline Rows pulls(std::size_t n) {
    Rows rows;
    const std::vector<SpringPull> all = set_points(small_template()).spring_pull;
    for (std::size_t i = 0; i < all.size(); i += n) rows.spring_pull.push_back(all[i]);
    return rows;
}

/// The first `seconds` of a template's log: the motors against each other.
inline Rows short_log(double seconds) {
    Rows rows;
    for (const LogRow& row : set_points(small_template()).log)
        if (row.time < seconds) rows.log.push_back(row);
    return rows;
}

inline Fit best_fit(const Problem& problem, const Causes& causes) { return fit(problem, causes, problem.start(causes)); }

}  // namespace fusee::gap::fixtures
