#include "identification/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/report/paper.h"
#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"
#include "search/page.h"
#include "simulation/page.h"

namespace fusee::report {

namespace {

using core::deg_from_rad;

std::string section(const std::string& title, const std::string& text, const std::string& body) {
    return "<section><h2>" + escape(title) + "</h2><p>" + escape(text) + "</p>" + body + "</section>\n";
}
std::string grid(const std::string& charts) { return "<div class=\"grid\">" + charts + "</div>"; }
Cell figure(double value, int digits = 4) { return {number(value, digits), "num"}; }
std::string span(const core::Range& range) { return number(range.low, 3) + " to " + number(range.high, 3); }

std::string overview(const Paper& paper) {
    std::vector<std::vector<Cell>> rows;
    for (const PaperClaim& claim : claims(paper))
        rows.push_back({{escape(claim.piece), ""}, {escape(claim.paper), ""}, {escape(claim.here), ""}});
    return section("Overview",
                   "The paper prints neither its springs nor its radii nor the data of figure 8: what stands here is of the same kind.",
                   html_table({"", "paper", "here"}, rows));
}

/// Figure 1 over the logarithm of c: what happens, happens within decades.
std::string noise_charts(const std::vector<NoiseCurve>& curves) {
    static constexpr const char* kColours[] = {"sum", "se", "pe", "linear"};
    const char* const log_c = "log10 of c in Nm/rad";
    constexpr double kMost = 4.0;  // a motor without a spring to ground hangs on c alone, which would flatten the rest
    Plot joint("Variance of the joint", log_c, "variance [rad^2]");
    Plot motor("Variance of the motor, up to " + number(kMost) + " rad^2", log_c, "variance [rad^2]");
    std::size_t colour = 0;
    for (const NoiseCurve& curve : curves) {
        if (curve.c.empty()) continue;
        const std::vector<double> x = column(curve.c, [](double c) { return std::log10(c); });
        const char* css = kColours[colour++ % std::size(kColours)];
        joint.curve(curve.name, x, curve.joint, css);
        motor.curve(curve.name, x, column(curve.motor, [](double v) { return v <= kMost ? v : kUnknown; }), css);
    }
    return grid(joint.from_zero().svg() + motor.from_zero().svg());
}

std::string noise_section(const Paper& paper) {
    std::string out = noise_charts(paper.figure_1);
    for (const NoiseCurve& curve : paper.figure_1)
        if (!curve.refusal.empty()) out += "<p>" + escape(curve.name + ": " + curve.refusal) + "</p>";
    return section("Figure 1: passive noise rejection",
                   "White torque noise; inertias 1 kg m^2, a = b = 1 Nm/rad, dampers 0.5 Nms/rad and densities 1 (Nm)^2 s unless said "
                   "otherwise: the paper prints none. Of the whole actuator: last section.",
                   out);
}

std::string hill_section(const HillFigure& hill) {
    static constexpr const char* kColours[] = {"se", "t", "pe"};
    Plot muscle("Force of a muscle with linear springs", "stretch [rad]", "force [Nm]");
    std::vector<std::vector<HillFigure::Row>> parts;
    for (const HillFigure::Row& row : hill.rows) {
        if (parts.empty() || parts.back().front().active != row.active) parts.emplace_back();
        parts.back().push_back(row);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto length = column(parts[i], [](const HillFigure::Row& r) { return r.length; });
        const char* css = kColours[i % std::size(kColours)];
        muscle.curve("series, active " + number(parts[i].front().active, 2) + " Nm", length,
                     column(parts[i], [](const HillFigure::Row& r) { return r.series; }), css);
    }
    muscle.points("parallel", column(hill.rows, [](const HillFigure::Row& r) { return r.length; }),
                  column(hill.rows, [](const HillFigure::Row& r) { return r.parallel; }), "sum");
    Plot passive("Passive tension of the nonlinear springs, both in series", "stretch [rad]", "force [Nm]");
    passive.curve("F_PE of the parallel arrangement", column(hill.passive, [](const HillFigure::Passive& p) { return p.length; }),
                  column(hill.passive, [](const HillFigure::Passive& p) { return p.force; }), "pe");
    const std::string text = fmt::format(
        "Series arrangement with K_SE {} and K_PE {} Nm/rad, the first prototype's at peak torque; the parallel one that is the same "
        "muscle "
        "has {} and {} Nm/rad. With nonlinear springs only the passive tension has a parallel arrangement.",
        number(hill.series.k_se, 3), number(hill.series.k_pe, 3), number(hill.parallel.k_se, 3), number(hill.parallel.k_pe, 3));
    return section("Figure 2: Hill's muscle", text, grid(muscle.svg() + passive.svg()));
}

std::string table_rows(const PaperTable& table) {
    std::vector<std::vector<Cell>> rows;
    const auto beside = [](double computed, double measured) -> Cell {
        const double less = deg_from_rad(computed - measured);
        return {number(deg_from_rad(computed)) + (std::isnan(less) ? "" : fmt::format(" ({:+.1f})", less)), "num"};
    };
    for (std::size_t i = 0; i < table.simulation.measured.size(); ++i) {
        const MeasuredRow& row = table.simulation.measured[i];
        rows.push_back({figure(row.tau), figure(deg_from_rad(row.measured)), beside(row.computed.linear, row.measured),
                        beside(row.computed.exact_width, row.measured), beside(row.computed.measured_width, row.measured),
                        figure(table.parallel[i], 2)});
    }
    return html_table({"tau [Nm]", "paper [deg]", "linear [deg]", "exact [deg]", "test reads [deg]", "implied K_PE [Nm/rad]"}, rows);
}

std::string table_section(const std::string& title, const PaperTable& table) {
    const Simulation& s = table.simulation;
    std::string out = table_rows(table) + "<ul>";
    for (const std::string& remark : remarks(s)) out += "<li>" + escape(remark) + "</li>";
    out += "</ul>" + grid(joint_charts(s));
    return section(
        title,
        fmt::format("Profile {}. Full widths at the joint, in brackets the difference from the paper's. The implied K_PE would "
                    "give the paper's width if the dead-band were linear; its capstan would turn by {} rad at most over the table.",
                    s.provenance.name, number(table.travel, 2)),
        out);
}

std::string widths(const core::Range& band) {
    return std::isfinite(band.high) ? span({deg_from_rad(band.low), deg_from_rad(band.high)}) : "everywhere";
}

std::string relatives_section(const Paper& paper) {
    std::vector<std::vector<Cell>> rows;
    for (std::size_t i = 0; i < paper.relatives.size(); ++i) {
        const actuator::ArrangementRow &row = paper.relatives[i].survey, &alone = paper.torque_control[i];
        rows.push_back({{escape(to_string(row.arrangement)), "code"},
                        {span(row.stiffness), "num"},
                        figure(row.torque, 3),
                        {span(alone.free_stiffness), "num"},
                        {widths(alone.dead_band), "num"},
                        {span(row.free_stiffness), "num"},
                        {widths(row.dead_band), "num"}});
    }
    return section(
        "The relatives",
        "The arrangements that the paper names, all with the same springs and gears. First under torque control as in the paper, "
        "then with the position loop at each motor that their profiles give.",
        html_table({"arrangement", "held [Nm/rad]", "torque [Nm]", "free [Nm/rad]", "dead-band [deg]", "free, loops", "dead-band, loops"},
                   rows));
}

std::string head(const Paper& paper) {
    const auto widths_of = [](const PaperTable& table) {
        const std::vector<SimulatedLevel>& levels = table.simulation.levels;
        return number(deg_from_rad(levels.front().dead_band.linear), 3) + " \u2192 " +
               number(deg_from_rad(levels.back().dead_band.linear), 3) + " deg";
    };
    return "<header><p class=\"eyebrow\">fusee, the paper anew</p><h1>Stiction compensation in agonist-antagonist variable stiffness "
           "actuators</h1><p class=\"stamp\">" +
           escape(paper.provenance.line()) + "</p><div class=\"tiles\">" +
           html_tile(widths_of(paper.table_1), "first prototype, linear dead-band over table I's torques") +
           html_tile(widths_of(paper.table_2), "new springs, over table II's") +
           html_tile(number(paper.figure_8.friction.trusted().through_zero_mu), "mu of the synthetic example") +
           html_tile(number(paper.figure_9.cost), "cost of the springs found") + "</div></header>\n";
}

}  // namespace

std::string paper_html(const Paper& paper) {
    std::string body = head(paper) + overview(paper) + noise_section(paper) + hill_section(paper.figure_2);
    body += section("Figure 6: dead-band",
                    "The first prototype at its peak torque: pushed up and released, pushed down and released, it rests at another place.",
                    grid(push_charts(paper.table_1.simulation)));
    body += section("Figure 8: friction of a gear", "Synthetic break-away rows, made by a random generator: the paper's are not printed.",
                    figure_8_chart(paper.figure_8.friction));
    body +=
        section("Figure 9: the search for springs",
                "Algorithm 1, " + paper.figure_9.provenance.name +
                    ". Lines: the other two variables at the optimum; dots: the lowest cost of all designs tried, as the paper draws it.",
                "");
    body += costs_section(paper.figure_9) + springs_section(paper.figure_9) + cams_section(paper.figure_9);
    body += table_section("Table I: first prototype", paper.table_1) + table_section("Table II: new springs", paper.table_2);
    body += relatives_section(paper);
    body +=
        section("Subsystems and noise of the new springs", "Motor: the gear alone. Frame: masses in place of motors. Noise: gears moving.",
                grid(subsystem_charts(paper.table_2.simulation)));
    return html_page("paper", body);
}

}  // namespace fusee::report
