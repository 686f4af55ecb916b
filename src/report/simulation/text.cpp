#include <fmt/format.h>

#include "data/figures.h"
#include "fusee/report/simulation.h"
#include "simulation/equilibria.h"

namespace fusee::report {

std::string simulation_text(const Simulation& s) {
    std::string text = fmt::format("{}\n  {:>8}  {:>10}  {:>10}  {:>10}  {:>13}  {:>13}  {:>11}\n", s.provenance.line(), "tau [Nm]",
                                   "linear", "exact", "measured", "condition (6)", "held [Nm/rad]", "capstan");
    for (const SimulatedLevel& level : s.levels) {
        const SimulatedDeadBand& d = level.dead_band;
        text +=
            fmt::format("  {:>8}  {:>10}  {:>10}  {:>10}  {:>13}  {:>13}  {:>11}\n", number(d.tau, 4), deg(d.linear), deg(d.exact_width),
                        deg(d.measured_width), number(d.condition_6, 3), number(d.joint_stiffness, 4), deg(d.theta));
    }
    for (const MeasuredRow& row : s.measured)
        text += fmt::format("  measured on the rig at {} Nm: {} deg; linear {}, exact {}, push and release {}\n", number(row.tau, 4),
                            deg(row.measured), deg(row.computed.linear), deg(row.computed.exact_width), deg(row.computed.measured_width));
    text += equilibria_text(s);
    for (const std::string& remark : remarks(s)) text += "  " + remark + "\n";
    for (const std::string& gap : s.gaps) text += "  not computed: " + gap + "\n";
    return text;
}

std::string survey_text(const std::vector<Simulation>& simulations) {
    std::string text = fmt::format("{:24} {:20} {:>18} {:>18} {:>12} {:>20}\n", "name", "arrangement", "held [Nm/rad]", "free [Nm/rad]",
                                   "torque [Nm]", "dead-band [deg]");
    for (const Simulation& s : simulations)
        text += fmt::format("{:24} {:20} {:>18} {:>18} {:>12} {:>20}\n", s.provenance.name, to_string(s.survey.arrangement),
                            span(s.survey.stiffness), span(s.survey.free_stiffness), number(s.survey.torque, 3),
                            span({deg_from_rad(s.survey.dead_band.low), deg_from_rad(s.survey.dead_band.high)}));
    return text;
}

}  // namespace fusee::report
