#pragma once
#include "fusee/core/units.h"
#include "fusee/effects/term.h"

/// The terms of each place.
namespace fusee::effects {

[[nodiscard]] std::vector<Term> gear_terms();
[[nodiscard]] std::vector<Term> spring_terms();
[[nodiscard]] std::vector<Term> joint_terms();

/// Experiments in which the joint or its motors move.
inline std::vector<Experiment> moving_experiments() {
    return {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog};
}

/// Ripple counts to try, per rad: 1.25 apart, since a run over 2 rad tells half of that apart; beyond 20 a ripple is shorter than a usual
/// step of rows.
[[nodiscard]] inline std::vector<double> ripple_counts(double most) {
    std::vector<double> counts;
    for (double n = 1.0; n <= most; n += 1.25) counts.push_back(n);
    return counts;
}

/// The count of a ripple, per rad, tried up to `most`.
[[nodiscard]] inline EffectParameter ripple_count(double scale, double at_first, double most) {
    return {"per_rad", "1", scale, {0.3, 40.0}, at_first, ripple_counts(most)};
}

/// The phase of a ripple. No tries: amplitude and phase of each count follow from its sine and its cosine (inference/screen.cpp).
[[nodiscard]] inline EffectParameter ripple_phase() { return {"phase", "rad", 2.0, {-2.0 * core::kPi, 2.0 * core::kPi}, 0.0}; }

/// What settles over a session, and its time constant.
[[nodiscard]] inline std::vector<EffectParameter> drift(const std::string& name, const std::string& unit, double scale,
                                                        core::Range allowed) {
    return {{name, unit, scale, allowed, 0.0}, {"time", "s", 200.0, {20.0, 2000.0}, 250.0, {80.0, 250.0, 800.0}}};
}

[[nodiscard]] inline joint_model::Drift drift_of(std::span<const double> values) { return {values[0], values[1]}; }

/// A share by which a figure of a part drifts. @param effect its law names that figure: "Friction"; its values are those of `drift`
[[nodiscard]] inline Term share_drift(Effect effect, const std::string& port, const std::string& figure) {
    effect.law += " is (1 + d (1 - exp(-t/T))) times at the time t of a session that makes the experiments in the format's order.";
    return {std::move(effect),
            port,
            "time",
            "session_s",
            "share",
            [](std::span<const double> v, double x) { return drift_of(v).factor(x); },
            "The " + figure + " changes by {share} % over the session, with a time constant of {second} s."};
}

[[nodiscard]] inline joint_model::Ripple ripple_of(std::span<const double> values) { return {values[0], values[1], values[2]}; }

/// A ripple over an angle, in this unit.
[[nodiscard]] inline Term ripple_term(Effect effect, const std::string& port, const std::string& angle, const std::string& unit,
                                      const std::string& sentence) {
    return {std::move(effect), port, "angle", angle, unit, [](std::span<const double> v, double x) { return ripple_of(v)(x); }, sentence};
}

}  // namespace fusee::effects
