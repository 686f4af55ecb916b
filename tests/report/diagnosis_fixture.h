#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"

namespace fusee::report {

/// A loop: load up, unload, load down, unload; what friction does to the joint's deflection.
inline diagnosis::Trace loop_trace(const std::string& label) {
    diagnosis::Trace trace{"joint_stiffness", label, "joint_torque_Nm", "q_rad", {}, {}, {}, {}, {}};
    for (int i = 0; i <= 80; ++i) {
        const double phase = i / 20.0,
                     x = 4.0 * (phase < 1   ? phase
                                : phase < 3 ? 2 - phase
                                            : phase - 4),
                     way = phase < 1 || phase > 3 ? 1 : -1;
        const double before = 0.08 * x - 0.02 * way, after = 0.08 * x - 0.05 * way;
        trace.x.push_back(x);
        trace.before.push_back(before);
        trace.after.push_back(after);
        trace.measured.push_back(after + 0.008 * std::sin(7.0 * i));
        trace.sigma.push_back(0.006);
    }
    return trace;
}

/// Levels measured three times over, in this order.
inline diagnosis::Trace repeat_trace(const std::string& label) {
    diagnosis::Trace trace{"dead_band", label, "cocontraction_Nm", "q_high_rad", {}, {}, {}, {}, {}};
    for (int repeat = 0; repeat < 3; ++repeat)
        for (const double tau : {0.1, 0.2, 0.3, 0.5, 0.8}) {
            trace.x.push_back(tau);
            trace.before.push_back(0.02 / tau);
            trace.after.push_back(0.03 / tau);
            trace.measured.push_back(0.03 / tau + 0.004 * std::sin(9.0 * tau + repeat));
            trace.sigma.push_back(0.003 + 0.01 * tau);
        }
    return trace;
}

inline diagnosis::Trace log_trace(const std::string& label, int points) {
    diagnosis::Trace trace{"log", label, "t_s", "theta_agonist_rad", {}, {}, {}, {}, {}};
    for (int i = 0; i < points; ++i) {
        const double t = i * 12.0 / points;
        trace.x.push_back(t);
        trace.before.push_back(0.9 * std::sin(1.3 * t) + 1.0);
        trace.after.push_back(0.8 * std::sin(1.3 * t - 0.1) + 1.0);
        trace.measured.push_back(trace.after.back() + 0.01 * std::sin(50.0 * t));
        trace.sigma.push_back(0.012);
    }
    return trace;
}

inline void add_map(diagnosis::Diagnosis& d, const std::string& experiment, const std::string& variable, std::vector<double> edges,
                    double gap) {
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        d.map.push_back({experiment,
                         variable,
                         {edges[i], edges[i + 1]},
                         gap / static_cast<double>(i + 1) + 0.9,
                         0.8 + 0.15 * static_cast<double>(i),
                         12});
}

inline diagnosis::Isolability isolability() {
    diagnosis::Isolability isolability;
    for (const char* id : {"gear.load_friction", "gear.coulomb", "se.rate", "se.radius", "sensor.torque_scale"})
        for (const char* side : {"agonist", "antagonist", "both"}) isolability.causes.push_back({id, side});
    isolability.causes.push_back({"joint.coulomb", "none"});
    const std::size_t n = isolability.causes.size();
    isolability.signature_similarity.assign(n, std::vector<double>(n, 0.0));
    for (std::size_t i = 0; i < n; ++i) {
        isolability.detectable.push_back(0.004 * static_cast<double>(i + 1));
        isolability.units.push_back(i / 3 == 1 || i == n - 1 ? "Nm" : i / 3 == 3 ? "m" : "relative");
        for (std::size_t j = 0; j < n; ++j)
            isolability.signature_similarity[i][j] = std::abs(std::cos(0.9 * (static_cast<double>(i) - static_cast<double>(j))));
    }
    isolability.signature_similarity[0][12] = isolability.signature_similarity[12][0] = 0.984;
    isolability.classes = {{0, 12}, {6, 9, 8}};
    return isolability;
}

/// The gap of each experiment, and the map; one held-out gap and one cell are unknown.
inline void add_gaps(diagnosis::Diagnosis& d) {
    int rows = 24;
    for (const char* name : {"breakaway", "spring_pull", "dead_band", "joint_stiffness", "cocontraction", "log"})
        d.experiments.push_back(
            {name, static_cast<std::size_t>(rows *= 2), {0.2 * rows / 6, 1.02, 1.0, 0.21 * rows / 6, 1.08, {0.9, 1.3}}, 1.05});
    d.experiments.back().gap.heldout_before = d.experiments.back().gap.heldout_after = diagnosis::kNoFigure;
    add_map(d, "breakaway", "motor_torque_Nm", {0.05, 0.3, 0.6, 0.9, 1.2}, 14.0);
    add_map(d, "spring_pull", "deflection_rad", {0.0, 0.5, 1.0, 1.5, 2.0, 2.5}, 2.4);
    add_map(d, "dead_band", "cocontraction_Nm", {0.12, 0.3, 0.5, 0.8}, 26.0);
    add_map(d, "joint_stiffness", "joint_torque_Nm", {-4, -2, 0, 2, 4}, 6.1);
    add_map(d, "log", "t_s", {0, 2, 4, 6, 8, 10, 12}, 0.5);
    d.map.push_back({"cocontraction", "motor_torque_Nm", {0.4, 0.4}, 3.3, diagnosis::kNoFigure, 2});
    d.map.push_back({"cocontraction", "motor_torque_Nm", {0.9, 1.3}, 2.2, 1.1, 2});
}

/// A full case: friction in the agonist's gear and a spool cut too deep.
inline diagnosis::Diagnosis diagnosis() {
    diagnosis::Diagnosis d;
    d.case_name = "open-07";
    d.case_sha256 = "0123456789abcdef0123";
    d.verdict = diagnosis::VerdictKind::kIdentified;
    d.effects = {{{"gear.coulomb", "agonist"}, 0.981, {0.0512, {0.0473, 0.0551}, "Nm"}, {}},
                 {{"se.radius", "both"}, 0.934, {-2.1e-4, {-2.6e-4, -1.6e-4}, "m"}, {{"v_s", 0.02}}}};
    d.alternatives = {{{{"gear.load_friction", "agonist"}, {"se.radius", "both"}}, 0.041}, {{}, 0.002}};
    d.where = {{"dead_band", 0.62, "cocontraction_Nm", {0.12, 0.5}, "agonist, push up"},
               {"breakaway", 0.27, "motor_torque_Nm", {0.05, 0.3}, "agonist, backdrive"},
               {"spring_pull", 0.11, "deflection_rad", {0.2, 1.4}, "K_SE"}};
    d.gap = {9.12, 1.04, 1.0, 9.31, 1.06, {0.97, 1.17}};
    d.next_experiment = "Hold the agonist's motor at 0.02, 0.05 and 0.1 Nm and raise the load until it breaks away, 5 times each.";
    d.next = {{d.next_experiment, "breakaway", {0.02, 0.05, 0.1}, "motor_torque_Nm", 1.72, 12.0},
              {"Pull the agonist's K_SE to 0.4 and 1.2 rad and back.", "spring_pull", {0.4, 1.2}, "deflection_rad", 0.6, 8.0}};
    d.build = {{"radii", {0.0011, {-0.002, 0.0042}, "relative"}}, {"se_radius agonist", {1.2e-5, {-3e-5, 5e-5}, "m"}}};
    add_gaps(d);
    double below = 0.0;
    for (const std::vector<effects::Cause>& effects : {std::vector<effects::Cause>{{"gear.coulomb", "agonist"}, {"se.radius", "both"}},
                                                       d.alternatives[0].effects,
                                                       {{"gear.coulomb", "agonist"}},
                                                       {{"joint.coulomb", "none"}},
                                                       {}})
        d.ranking.push_back({effects, -(below += below + 3.0) + 3.0, 0.95 * std::exp(3.0 - below), 310.0 + 7.0 * below, 1.0 + 0.2 * below,
                             std::vector<diagnosis::Parameter>(effects.size(), {0.051, {0.04, 0.06}, "Nm"})});
    d.isolability = isolability();
    d.traces = {loop_trace("q over joint torque at 0.5 Nm"), loop_trace("q over joint torque at 1 Nm"), repeat_trace("upper edge"),
                log_trace("agonist capstan", 400)};
    d.remarks = {"Leaving out the time log does not change the verdict.", "The dead-band's rows above 0.5 Nm are at the floor."};
    return d;
}

}  // namespace fusee::report
