#include "simulation/page.h"

#include <fmt/format.h>

#include <cmath>

#include "page/html.h"

namespace fusee::report {

namespace {

bool is_pnrvsa(const Simulation& s) { return s.survey.arrangement == actuator::Arrangement::kPnrvsa; }

std::string condition_tag(const actuator::ConditionSummary& condition) {
    const std::string values = " (" + span(condition.values, 2) + ")";
    switch (condition_verdict(condition)) {
        case ConditionVerdict::kHolds:
            return verdict_tag(core::Severity::kPass, "Condition (6) holds: less stiction with co-contraction" + values);
        case ConditionVerdict::kFails:
            return verdict_tag(core::Severity::kError, "Condition (6) fails: more stiction with co-contraction" + values);
        case ConditionVerdict::kMixed:
            return verdict_tag(core::Severity::kWarning, "Condition (6) holds in part" + values);
        case ConditionVerdict::kWithinRounding:
            return verdict_tag(core::Severity::kWarning, "Condition (6) holds only within rounding" + values);
        case ConditionVerdict::kNotKnown:
            break;
    }
    return verdict_tag(core::Severity::kWarning, "Condition (6) is unknown");
}

Head simulation_head(const Simulation& s) {
    const SimulatedDeadBand &first = s.levels.front().dead_band, &last = s.levels.back().dead_band;
    const auto change_in_degrees = [](double from, double to) { return change(deg_from_rad(from), deg_from_rad(to)) + " deg"; };
    const std::string levels = span({first.tau, last.tau}) + " Nm";
    Head head{"fusee simulation", s.provenance.name, is_pnrvsa(s) ? condition_tag(s.condition) : "", "", s.provenance.line(), {}};
    if (is_pnrvsa(s))
        head.tiles.emplace_back(change_in_degrees(first.measured_width, last.measured_width), "dead-band by push and release, " + levels);
    head.tiles.emplace_back(change_in_degrees(first.linear, last.linear), "linear dead-band, " + levels);
    head.tiles.emplace_back(span(s.survey.stiffness) + " Nm/rad", "joint stiffness, capstans held");
    head.tiles.emplace_back(newton_metres(s.survey.torque), "greatest joint torque within the laws of the springs");
    return head;
}

std::string level_section(const Simulation& s) {
    Rows rows;
    for (const SimulatedLevel& level : s.levels) {
        const SimulatedDeadBand& d = level.dead_band;
        rows.push_back({num(d.tau), num(deg(d.linear)), num(deg(d.exact_width)), num(deg(d.measured_width)), num(deg(level.within_laws)),
                        num(d.condition_6, 3), num(d.joint_stiffness), num(d.free_joint_stiffness), num(level.reading.push_torque, 3),
                        num(level.reading.full_push, 3)});
    }
    return section("Levels of co-contraction",
                   html_table("Dead-band and stiffness at each level",
                              {"tau [Nm]", "linear [deg]", "exact [deg]", "measured [deg]", "within the laws [deg]", "condition (6)",
                               "held [Nm/rad]", "free [Nm/rad]", "push [Nm]", "full push [Nm]"},
                              rows));
}

/// Equilibrium (1) and sensitivity (2) at equal co-contraction: the joint stays at 0, both capstans turn equally.
std::string equilibrium_section(const Simulation& s) {
    Rows rows;
    for (const SimulatedLevel& level : s.levels) {
        const auto& m = level.sensitivity;
        rows.push_back({num(level.dead_band.tau), num(level.dead_band.theta), num(m(0, 0), 3), num(m(0, 1), 3), num(m(0, 2), 3),
                        num(m(2, 0), 3), num(m(2, 2), 3)});
    }
    return section(
        "Equilibrium and sensitivity",
        paragraph("At equal co-contraction the joint stays at 0 and both capstans at theta. Sensitivities are the paper's matrix "
                  "(2) in rad/Nm; the other entries follow by symmetry.") +
            html_table(
                "Sensitivities at each level",
                {"tau [Nm]", "theta [rad]", "d theta_1/d tau_1", "d theta_1/d tau_2", "d theta_1/d tau_q", "d q/d tau_1", "d q/d tau_q"},
                rows));
}

std::string measured_section(const Simulation& s) {
    if (s.measured.empty()) return "";
    Rows rows;
    for (const MeasuredRow& row : s.measured)
        rows.push_back({num(row.tau), num(deg(row.measured)), compared(row.computed.linear, row.measured),
                        compared(row.computed.exact_width, row.measured), compared(row.computed.measured_width, row.measured)});
    return section("Comparison with the measured table",
                   paragraph("Full widths in degrees; in brackets the difference from the measured width.") +
                       html_table("Measured and computed widths", {"tau [Nm]", "measured", "linear", "exact", "push and release"}, rows));
}

std::string survey_section(const Simulation& s) {
    const actuator::ArrangementRow& row = s.survey;
    return section(
        "Summary of the arrangement",
        card(html_facts({{"arrangement", to_string(row.arrangement)},
                         {"stiffness, capstans held", span(row.stiffness) + " Nm/rad"},
                         {"stiffness, capstans free", span(row.free_stiffness) + " Nm/rad"},
                         {"joint torque within the laws", newton_metres(row.torque)},
                         {"linear dead-band", span({deg_from_rad(row.dead_band.low), deg_from_rad(row.dead_band.high)}) + " deg"}})));
}

std::string charts_section(const char* title, const char* text, const std::string& charts) {
    return section(title, paragraph(text) + grid(charts));
}

}  // namespace

std::string simulation_html(const Simulation& s) {
    std::vector<std::string> words = remarks(s);
    for (const std::string& gap : s.gaps) words.push_back("Unknown: " + gap);
    std::string body = section("Results", bullet_list(words)) + equilibria_section(s);
    if (is_pnrvsa(s)) {
        body += measured_section(s);
        body += charts_section(
            "The joint over co-contraction",
            "Linear: paper (3)-(4). Exact: the distance of the outermost positions in which gear friction can hold the joint. "
            "Push and release: the width that a test measures; it depends on the path.",
            joint_charts(s));
        body += level_section(s) + equilibrium_section(s);
        body +=
            charts_section("Pushed and released",
                           "Friction acts on each capstan as a play: the capstan stays until its load leaves the limits.", push_charts(s));
        body += charts_section("Subsystems and noise",
                               "Motor: the gear alone. Frame: the joint with masses in place of motors. Noise: moving gears, so without "
                               "stiction; inertia, drag and noise as in [dynamics].",
                               subsystem_charts(s));
        body += wrap_section(s) + survey_section(s);
    } else {
        body += survey_section(s) + level_section(s);
    }
    return html_page(s.provenance.name, simulation_head(s), body);
}

}  // namespace fusee::report
