#include "identification/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/report/paper.h"
#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"
#include "search/page.h"
#include "simulation/page.h"

namespace fusee::report {

namespace {

std::string overview_section(const Paper& paper) {
    Rows rows;
    for (const PaperClaim& claim : claims(paper)) rows.push_back({plain(claim.piece), plain(claim.paper), plain(claim.here)});
    return section("Overview",
                   paragraph("The paper states neither its springs, its radii nor the data of figure 8. The designs here are of "
                             "the same kind.") +
                       html_table("The paper's statements, and the results here", {"piece", "paper", "here"}, rows));
}

/// Figure 1 over the logarithm of c, which spans decades.
std::string noise_curves(const std::vector<NoiseCurve>& curves) {
    static constexpr const char* kColours[] = {"sum", "se", "pe", "linear"};
    const char* const log_c = "log10 of c in Nm/rad";
    constexpr double kMostVariance = 4.0;  // without a spring to ground only c holds the motor, which would flatten the other curves
    Plot joint("Variance of the joint", log_c, "variance [rad^2]");
    Plot motor("Variance of the motor, up to " + number(kMostVariance) + " rad^2", log_c, "variance [rad^2]");
    std::size_t colour = 0;
    for (const NoiseCurve& curve : curves) {
        if (curve.c.empty()) continue;
        const std::vector<double> x = column(curve.c, [](double c) { return std::log10(c); });
        const char* css = kColours[colour++ % std::size(kColours)];
        joint.curve(curve.name, x, curve.joint, css);
        motor.curve(curve.name, x, column(curve.motor, [](double v) { return v <= kMostVariance ? v : kUnknown; }), css);
    }
    return grid(joint.from_zero().svg() + motor.from_zero().svg());
}

std::string noise_section(const Paper& paper) {
    std::string out = paragraph(
        "White torque noise. Unless stated otherwise: inertias 1 kg m^2, a = b = 1 Nm/rad, dampers 0.5 Nms/rad, densities 1 (Nm)^2 s; the "
        "paper states none. The last section shows the whole actuator.");
    out += noise_curves(paper.figure_1);
    for (const NoiseCurve& curve : paper.figure_1)
        if (!curve.refusal.empty()) out += paragraph(curve.name + ": " + curve.refusal);
    return section("Figure 1: passive noise rejection", out);
}

std::string hill_section(const HillFigure& hill) {
    using Row = HillFigure::Row;
    static constexpr const char* kColours[] = {"se", "t", "pe"};
    Plot muscle("Force of a muscle with linear springs", "stretch [rad]", "force [Nm]");
    std::vector<std::vector<Row>> levels;
    for (const Row& row : hill.rows) {
        if (levels.empty() || levels.back().front().active != row.active) levels.emplace_back();
        levels.back().push_back(row);
    }
    for (std::size_t i = 0; i < levels.size(); ++i)
        muscle.curve("series, active " + newton_metres(levels[i].front().active, 2), column(levels[i], &Row::length),
                     column(levels[i], &Row::series), kColours[i % std::size(kColours)]);
    muscle.points("parallel", column(hill.rows, &Row::length), column(hill.rows, &Row::parallel), "sum");
    Plot passive("Passive tension of the nonlinear springs, both in series", "stretch [rad]", "force [Nm]");
    passive.curve("F_PE of the parallel arrangement", column(hill.passive, &HillFigure::Passive::length),
                  column(hill.passive, &HillFigure::Passive::force), "pe");
    const auto springs = [](const actuator::LinearMuscle& m) {
        return fmt::format("K_SE {} and K_PE {} Nm/rad", number(m.k_se, 3), number(m.k_pe, 3));
    };
    return section(
        "Figure 2: Hill's muscle",
        paragraph(fmt::format("The series arrangement has {}, the first prototype's values at peak torque. The equivalent parallel "
                              "arrangement has {}. With nonlinear springs only the passive tension has a parallel arrangement.",
                              springs(hill.series), springs(hill.parallel))) +
            grid(muscle.svg() + passive.svg()));
}

std::string table_rows(const PaperTable& table) {
    Rows rows;
    for (std::size_t i = 0; i < table.simulation.measured.size(); ++i) {
        const MeasuredRow& row = table.simulation.measured[i];
        rows.push_back({num(row.tau), num(deg(row.measured)), compared(row.computed.linear, row.measured),
                        compared(row.computed.exact_width, row.measured), compared(row.computed.measured_width, row.measured),
                        num(table.parallel[i], 2)});
    }
    return html_table("Dead-bands of the paper and computed",
                      {"tau [Nm]", "paper [deg]", "linear [deg]", "exact [deg]", "push and release [deg]", "implied K_PE [Nm/rad]"}, rows);
}

std::string paper_table_section(const std::string& title, const PaperTable& table) {
    const Simulation& s = table.simulation;
    return section(title,
                   paragraph(fmt::format("Profile {}. Full widths at the joint; in brackets the difference from the paper. The implied "
                                         "K_PE would give the paper's width if the dead-band were linear; its capstan would turn by at "
                                         "most {} rad over the table.",
                                         s.provenance.name, number(table.travel, 2))) +
                       table_rows(table) + bullet_list(remarks(s)) + grid(joint_charts(s)));
}

std::string width_range(const core::Range& band) {
    return std::isfinite(band.high) ? span({deg_from_rad(band.low), deg_from_rad(band.high)}) : "everywhere";
}

std::string relatives_section(const Paper& paper) {
    Rows rows;
    for (std::size_t i = 0; i < paper.relatives.size(); ++i) {
        const actuator::ArrangementRow &row = paper.relatives[i].survey, &alone = paper.torque_control[i];
        rows.push_back({code(to_string(row.arrangement)), num(span(row.stiffness)), num(row.torque, 3), num(span(alone.free_stiffness)),
                        num(width_range(alone.dead_band)), num(span(row.free_stiffness)), num(width_range(row.dead_band))});
    }
    return section(
        "Related arrangements",
        paragraph("The arrangements that the paper names, with equal springs and gears: under torque control as in the paper, and with the "
                  "motor position loops of their profiles.") +
            html_table(
                "Stiffness, torque and dead-band of each arrangement",
                {"arrangement", "held [Nm/rad]", "torque [Nm]", "free [Nm/rad]", "dead-band [deg]", "free, loops", "dead-band, loops"},
                rows));
}

Head paper_head(const Paper& paper) {
    const auto widths_of = [](const PaperTable& table) {
        const std::vector<SimulatedLevel>& levels = table.simulation.levels;
        return change(deg_from_rad(levels.front().dead_band.linear), deg_from_rad(levels.back().dead_band.linear)) + " deg";
    };
    return {"fusee: the paper reproduced",
            "Stiction compensation in agonist-antagonist variable stiffness actuators",
            "",
            "",
            paper.provenance.line(),
            {{widths_of(paper.table_1), "first prototype, linear dead-band over the torques of table I"},
             {widths_of(paper.table_2), "new springs, linear dead-band over the torques of table II"},
             {number(paper.figure_8.friction.trusted().through_zero_mu), "mu of the synthetic example"},
             {number(paper.figure_9.cost), "cost of the springs found"}}};
}

}  // namespace

std::string paper_html(const Paper& paper) {
    std::string body = overview_section(paper) + noise_section(paper) + hill_section(paper.figure_2);
    body += section("Figure 6: dead-band", paragraph("The first prototype at its peak torque rests at different angles after a push up and "
                                                     "after a push down.") +
                                               grid(push_charts(paper.table_1.simulation)));
    body += section("Figure 8: friction of a gear",
                    paragraph("Synthetic break-away rows from a random generator: the paper does not state its rows.") +
                        figure_8_chart(paper.figure_8.friction));
    body += section("Figure 9: the search for springs",
                    paragraph("Algorithm 1, " + paper.figure_9.provenance.name +
                              ". Lines: the other two variables at the optimum. Dots: the lowest cost of all designs of the search, as in "
                              "the paper."));
    body += costs_section(paper.figure_9) + springs_section(paper.figure_9) + cams_section(paper.figure_9);
    body += paper_table_section("Table I: first prototype", paper.table_1) + paper_table_section("Table II: new springs", paper.table_2);
    body += relatives_section(paper);
    body += section("Subsystems and noise of the new springs",
                    paragraph("Motor: the gear alone. Frame: masses in place of motors. Noise: moving gears.") +
                        grid(subsystem_charts(paper.table_2.simulation)));
    return html_page("paper", paper_head(paper), body);
}

}  // namespace fusee::report
