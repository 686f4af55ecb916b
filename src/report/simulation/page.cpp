#include "simulation/page.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "page/html.h"

namespace fusee::report {

namespace {

using core::deg_from_rad;

std::string deg(double rad, int digits = 4) { return number(deg_from_rad(rad), digits); }
std::string span(const core::Range& range, const std::string& unit) {
    return number(range.low, 3) + " to " + number(range.high, 3) + " " + unit;
}
Cell figure(double value, int digits = 4) { return {number(value, digits), "num"}; }

std::string verdict_tag(const actuator::ConditionSummary& condition) {
    const std::string margin = fmt::format(" ({} to {})", number(condition.values.low, 2), number(condition.values.high, 2));
    switch (condition_verdict(condition)) {
        case ConditionVerdict::kHolds:
            return "<span class=\"verdict pass-tag\">\u2713 Condition (6) holds: less stiction with co-contraction" + margin + "</span>";
        case ConditionVerdict::kFails:
            return "<span class=\"verdict required-tag\">\u2715 Condition (6) fails: more stiction with co-contraction" + margin +
                   "</span>";
        case ConditionVerdict::kMixed:
            return "<span class=\"verdict review-tag\">! Condition (6) holds in part" + margin + "</span>";
        case ConditionVerdict::kWithinRounding:
            return "<span class=\"verdict review-tag\">! Condition (6) is met within rounding only" + margin + "</span>";
        case ConditionVerdict::kNotKnown:
            break;
    }
    return "<span class=\"verdict review-tag\">! Condition (6) is not known</span>";
}

bool is_paper(const Simulation& s) { return s.survey.arrangement == actuator::Arrangement::kPnrvsa; }

std::string head(const Simulation& s) {
    const actuator::DeadBand &first = s.levels.front().dead_band, &last = s.levels.back().dead_band;
    std::string out = "<header><p class=\"eyebrow\">fusee simulation</p><h1>" + escape(s.provenance.name) + "</h1>" +
                      (is_paper(s) ? verdict_tag(s.condition) : "") + "<p class=\"stamp\">" + escape(s.provenance.line()) +
                      "</p><div class=\"tiles\">";
    const auto change = [](double from, double to) { return deg(from, 3) + " \u2192 " + deg(to, 3) + " deg"; };
    const std::string levels = fmt::format("{} to {} Nm", number(first.tau, 3), number(last.tau, 3));
    if (is_paper(s)) out += html_tile(change(first.measured_width, last.measured_width), "read by a push-and-release test, " + levels);
    out += html_tile(change(first.linear, last.linear), "linear dead-band, " + levels);
    out += html_tile(span(s.survey.stiffness, "Nm/rad"), "joint stiffness, capstans held");
    out += html_tile(number(s.survey.torque, 3) + " Nm", "greatest joint torque within the springs' laws");
    return out + "</div></header>\n";
}

std::string words(const Simulation& s) {
    std::string out = "<section><h2>What it shows</h2><ul>";
    for (const std::string& remark : remarks(s)) out += "<li>" + escape(remark) + "</li>";
    for (const std::string& gap : s.gaps) out += "<li>Not known: " + escape(gap) + "</li>";
    return out + "</ul></section>\n";
}

std::string level_section(const Simulation& s) {
    std::vector<std::vector<Cell>> rows;
    for (const SimulatedLevel& level : s.levels) {
        const actuator::DeadBand& d = level.dead_band;
        rows.push_back({figure(d.tau), figure(deg_from_rad(d.linear)), figure(deg_from_rad(d.exact_width)),
                        figure(deg_from_rad(d.measured_width)), figure(deg_from_rad(level.within_laws)), figure(d.condition_6, 3),
                        figure(d.joint_stiffness), figure(d.free_joint_stiffness), figure(level.reading.push_torque, 3),
                        figure(level.reading.full_push, 3)});
    }
    return "<section><h2>Levels of co-contraction</h2>" +
           html_table({"tau [Nm]", "linear [deg]", "exact [deg]", "test reads [deg]", "within the laws [deg]", "condition (6)",
                       "held [Nm/rad]", "free [Nm/rad]", "push [Nm]", "full push [Nm]"},
                      rows) +
           "</section>\n";
}

/// Equilibrium (1) and sensitivity (2) at equal co-contraction: the joint stays at 0, both capstans turn alike.
std::string equilibrium_section(const Simulation& s) {
    std::vector<std::vector<Cell>> rows;
    for (const SimulatedLevel& level : s.levels) {
        const auto& m = level.sensitivity;
        rows.push_back({figure(level.dead_band.tau), figure(level.dead_band.theta), figure(m(0, 0), 3), figure(m(0, 1), 3),
                        figure(m(0, 2), 3), figure(m(2, 0), 3), figure(m(2, 2), 3)});
    }
    return "<section><h2>Equilibrium and sensitivity</h2><p>At equal co-contraction the joint stays at 0 and both capstans stand at theta. "
           "Sensitivities are the paper's matrix (2) in rad/Nm; what is not listed follows by symmetry.</p>" +
           html_table(
               {"tau [Nm]", "theta [rad]", "d theta_1/d tau_1", "d theta_1/d tau_2", "d theta_1/d tau_q", "d q/d tau_1", "d q/d tau_q"},
               rows) +
           "</section>\n";
}

std::string measured_section(const Simulation& s) {
    if (s.measured.empty()) return "";
    std::vector<std::vector<Cell>> rows;
    const auto beside = [](double computed, double measured) -> Cell {
        const double d = deg_from_rad(computed - measured);
        return {number(deg_from_rad(computed), 4) + (std::isnan(d) ? "" : fmt::format(" ({:+.1f})", d)), "num"};
    };
    for (const MeasuredRow& row : s.measured)
        rows.push_back({figure(row.tau), figure(deg_from_rad(row.measured)), beside(row.computed.linear, row.measured),
                        beside(row.computed.exact_width, row.measured), beside(row.computed.measured_width, row.measured)});
    return "<section><h2>Beside what was measured</h2><p>Full widths in degrees; in brackets the difference from the measured one.</p>" +
           html_table({"tau [Nm]", "measured", "linear", "exact", "test reads"}, rows) + "</section>\n";
}

std::string survey_section(const Simulation& s) {
    const actuator::ArrangementRow& row = s.survey;
    return "<section><h2>Beside its relatives</h2><div class=\"card\">" +
           html_facts({{"arrangement", to_string(row.arrangement)},
                       {"stiffness, capstans held", span(row.stiffness, "Nm/rad")},
                       {"stiffness, capstans free", span(row.free_stiffness, "Nm/rad")},
                       {"joint torque within the laws", number(row.torque, 3) + " Nm"},
                       {"linear dead-band", span({deg_from_rad(row.dead_band.low), deg_from_rad(row.dead_band.high)}, "deg")}}) +
           "</div></section>\n";
}

std::string grid(const std::string& title, const std::string& text, const std::string& charts) {
    return "<section><h2>" + title + "</h2><p>" + text + "</p><div class=\"grid\">" + charts + "</div></section>\n";
}

}  // namespace

std::string simulation_html(const Simulation& s) {
    std::string body = head(s) + words(s);
    body += equilibria_section(s);
    if (!is_paper(s)) return html_page(s.provenance.name, body + survey_section(s) + level_section(s));
    body += measured_section(s);
    body +=
        grid("The joint over co-contraction",
             "Linear: paper (3)-(4). Exact: the widest pair of places at which gear friction can hold the joint. Push and release: what a "
             "test reads, which depends on the path.",
             joint_charts(s));
    body += level_section(s) + equilibrium_section(s);
    body += grid("Pushed and released", "Each capstan is a play whose limits are its friction: it stays until its load leaves them.",
                 push_charts(s));
    body +=
        grid("Subsystems and noise",
             "Motor: the gear alone. Frame: the joint with masses for motors. Noise: gears moving, so without stiction; inertia, drag and "
             "noise as in [dynamics].",
             subsystem_charts(s));
    body += wrap_section(s);
    return html_page(s.provenance.name, body + survey_section(s));
}

}  // namespace fusee::report
