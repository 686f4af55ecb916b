#include "fusee/report/pareto.h"

#include <fmt/format.h>

#include "data/csv.h"
#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

using core::mm_from_m;

double other_axis(const ParetoReport& report, const ParetoPoint& p) { return report.against_size ? mm_from_m(p.radius) : p.travel; }

Head front_head(const ParetoReport& report) {
    return {
        "fusee front of designs",
        report.provenance.name,
        verdict_tag(core::Severity::kPass, "Every design shown was made and read back"),
        "",
        report.provenance.line(),
        {{std::to_string(report.points.size()), "designs"},
         {std::to_string(report.dropped), "dropped: could not be made"},
         {std::to_string(report.evaluations), fmt::format("evaluations, {} generations of {}{}, seed {}", report.generations,
                                                          report.population, report.interrupted ? ", stopped early" : "", report.seed)}}};
}

std::string front_section(const ParetoReport& report) {
    const auto figures = column(report.points, [](const ParetoPoint& p) { return deg_from_rad(p.figure); });
    const auto other = column(report.points, [&](const ParetoPoint& p) { return other_axis(report, p); });
    Plot front(report.against_size ? "Dead-band against size" : "Dead-band against capstan travel",
               report.against_size ? "largest contour radius of both cams [mm]"
                                   : fmt::format("capstan travel from {:g} to {:g} Nm [rad]", report.loads.low, report.loads.high),
               "exact dead-band at the joint [deg]");
    front.points("designs", other, figures, "se");
    Plot levels("Dead-band of each design", kCoContractionAxis, "exact dead-band at the joint [deg]");
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        const bool first = i == 0, last = i + 1 == report.points.size();
        if (!first && !last && i % 4 != 0) continue;  // every fourth, so that the curves can be distinguished
        std::vector<double> degrees;
        for (const double width : report.points[i].dead_band) degrees.push_back(deg_from_rad(width));
        levels.curve(report.points[i].file, report.torques, degrees, first ? "se" : last ? "pe" : "linear", !first && !last);
    }
    return section("The front", grid(front.from_zero().svg() + levels.from_zero().svg()));
}

std::string designs_section(const ParetoReport& report) {
    std::vector<std::string> names{"profile", "dead-band [deg]"};
    for (const double torque : report.torques) names.push_back(fmt::format("at {:g} Nm", torque));
    names.insert(names.end(), {"travel [rad]", "stiffness [Nm/rad]", "radius [mm]", "r_c [mm]", "limited by"});
    Rows rows;
    for (const ParetoPoint& p : report.points) {
        std::vector<Cell>& row = rows.emplace_back(std::vector<Cell>{code(p.file), num(deg(p.figure))});
        for (const double width : p.dead_band) row.push_back(num(deg(width)));
        row.insert(row.end(), {num(p.travel), num(span(p.stiffness)), num(mm_from_m(p.radius)), num(mm_from_m(p.capstan_radius)),
                               plain(p.limited_by)});
    }
    const std::string dropped =
        report.dropped_by.empty() ? "" : paragraph("Rules that the dropped designs break:") + bullet_list(report.dropped_by);
    return section("Designs", html_table("Designs of the front", names, rows) + dropped);
}

}  // namespace

std::string pareto_csv(const ParetoReport& report) {
    std::string csv = "profile,figure_deg";
    for (const double torque : report.torques) csv += fmt::format(",dead_band_at_{:g}_Nm_deg", torque);
    csv += ",travel_rad,soft_Nm_per_rad,stiff_Nm_per_rad,radius_mm,capstan_radius_mm\n";
    for (const ParetoPoint& p : report.points) {
        csv += fmt::format("{},{:.17g}", p.file, deg_from_rad(p.figure));
        for (const double width : p.dead_band) csv += fmt::format(",{:.17g}", deg_from_rad(width));
        csv += ",";
        add_csv_row(csv, p.travel, p.stiffness.low, p.stiffness.high, mm_from_m(p.radius), mm_from_m(p.capstan_radius));
    }
    return csv;
}

std::string pareto_html(const ParetoReport& report) {
    return html_page(report.provenance.name, front_head(report), front_section(report) + designs_section(report));
}

}  // namespace fusee::report
