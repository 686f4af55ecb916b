#include "fusee/report/pareto.h"

#include <fmt/format.h>

#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

using core::deg_from_rad;
using core::mm_from_m;

double other_axis(const ParetoReport& report, const ParetoPoint& p) { return report.against_size ? mm_from_m(p.radius) : p.travel; }

std::string head(const ParetoReport& report) {
    return "<header><p class=\"eyebrow\">fusee front of designs</p><h1>" + escape(report.provenance.name) +
           "</h1><span class=\"verdict pass-tag\">\u2713 Every design shown was made and read back</span><p class=\"stamp\">" +
           escape(report.provenance.line()) + "</p><div class=\"tiles\">" + html_tile(fmt::format("{}", report.points.size()), "designs") +
           html_tile(fmt::format("{}", report.dropped), "dropped: could not be made") +
           html_tile(fmt::format("{}", report.evaluations),
                     fmt::format("evaluations, {} generations of {}{}, seed {}", report.generations, report.population,
                                 report.interrupted ? ", stopped early" : "", report.seed)) +
           "</div></header>\n";
}

std::string picture(const ParetoReport& report) {
    const auto figures = column(report.points, [](const ParetoPoint& p) { return deg_from_rad(p.figure); });
    const auto other = column(report.points, [&](const ParetoPoint& p) { return other_axis(report, p); });
    Plot front(report.against_size ? "Dead-band against size" : "Dead-band against capstan travel",
               report.against_size ? "largest contour radius of both cams [mm]"
                                   : fmt::format("capstan travel from {:g} to {:g} Nm [rad]", report.loads.low, report.loads.high),
               "exact dead-band at the joint [deg]");
    front.points("designs", other, figures, "se");
    Plot levels("Dead-band of each design", "co-contraction, motor torque at the capstan [Nm]", "exact dead-band at the joint [deg]");
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        const bool first = i == 0, last = i + 1 == report.points.size();
        if (!first && !last && i % 4 != 0) continue;  // every fourth, so that they can be told apart
        std::vector<double> degrees;
        for (const double width : report.points[i].dead_band) degrees.push_back(deg_from_rad(width));
        levels.curve(report.points[i].file, report.torques, degrees, first ? "se" : last ? "pe" : "linear", !first && !last);
    }
    return "<section><h2>The front</h2><div class=\"grid\">" + front.from_zero().svg() + levels.from_zero().svg() + "</div></section>\n";
}

std::string table(const ParetoReport& report) {
    std::vector<std::string> names{"profile", "dead-band [deg]"};
    for (const double torque : report.torques) names.push_back(fmt::format("at {:g} Nm", torque));
    for (const char* name : {"travel [rad]", "stiffness [Nm/rad]", "radius [mm]", "r_c [mm]", "limited by"}) names.emplace_back(name);
    std::vector<std::vector<Cell>> rows;
    for (const ParetoPoint& p : report.points) {
        std::vector<Cell> row{{escape(p.file), "code"}, {number(deg_from_rad(p.figure)), "num"}};
        for (const double width : p.dead_band) row.push_back({number(deg_from_rad(width)), "num"});
        row.push_back({number(p.travel), "num"});
        row.push_back({number(p.stiffness.low, 3) + " to " + number(p.stiffness.high, 3), "num"});
        row.push_back({number(mm_from_m(p.radius)), "num"});
        row.push_back({number(mm_from_m(p.capstan_radius)), "num"});
        row.push_back({escape(p.limited_by), ""});
        rows.push_back(std::move(row));
    }
    std::string out = "<section><h2>Designs</h2>" + html_table(names, rows);
    if (report.dropped_by.empty()) return out + "</section>\n";
    out += "<p>Dropped points were forbidden by:</p><ul>";
    for (const std::string& rule : report.dropped_by) out += "<li>" + escape(rule) + "</li>";
    return out + "</ul></section>\n";
}

}  // namespace

std::string pareto_csv(const ParetoReport& report) {
    std::string csv = "profile,figure_deg";
    for (const double torque : report.torques) csv += fmt::format(",dead_band_at_{:g}_Nm_deg", torque);
    csv += ",travel_rad,soft_Nm_per_rad,stiff_Nm_per_rad,radius_mm,capstan_radius_mm\n";
    for (const ParetoPoint& p : report.points) {
        csv += fmt::format("{},{:.17g}", p.file, deg_from_rad(p.figure));
        for (const double width : p.dead_band) csv += fmt::format(",{:.17g}", deg_from_rad(width));
        csv += fmt::format(",{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", p.travel, p.stiffness.low, p.stiffness.high, mm_from_m(p.radius),
                           mm_from_m(p.capstan_radius));
    }
    return csv;
}

std::string pareto_html(const ParetoReport& report) {
    return html_page(report.provenance.name, head(report) + picture(report) + table(report));
}

}  // namespace fusee::report
