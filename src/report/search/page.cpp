#include "search/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "design/page.h"
#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

constexpr double kNoPoint = std::numeric_limits<double>::quiet_NaN();  // of a curve

std::string with_unit(const std::string& name, const std::string& unit) { return unit.empty() ? name : name + " [" + unit + "]"; }

bool can_be_cut(const SearchReport& report) {
    return std::all_of(report.cams.begin(), report.cams.end(), [](const CamCurve& cam) { return cam.part.has_value(); }) &&
           !core::any_error(report.findings);
}

std::string search_verdict(const SearchReport& report) {
    if (report.cams.empty()) return verdict_tag(core::Severity::kPass, "Springs found");
    return can_be_cut(report) ? verdict_tag(core::Severity::kPass, "Springs found; their cams can be made")
                              : verdict_tag(core::Severity::kWarning, "Springs found; these base springs cannot carry them");
}

Head search_head(const SearchReport& report) {
    Head head{"fusee spring design", report.provenance.name, search_verdict(report), "", report.provenance.line(), {}};
    for (const SearchedVariable& v : report.variables) head.tiles.emplace_back(number(v.found), with_unit(v.name, v.unit));
    head.tiles.emplace_back(number(report.cost), "cost");
    head.tiles.emplace_back(std::to_string(report.evaluations), fmt::format("evaluations in {} generations{}, seed {}", report.generations,
                                                                            report.interrupted ? ", stopped early" : "", report.seed));
    return head;
}

std::string comparison_section(const SearchReport& report) {
    Rows rows;
    for (const SearchedVariable& v : report.variables)
        rows.push_back({plain(v.name), num(v.found, 5), num(v.own, 5), plain(v.unit), num(span(v.box, 4))});
    for (const ComparedFigure& f : report.figures)
        rows.push_back({plain(f.name), num(f.found, 5), num(f.own, 5), plain(f.unit), plain("")});
    return section("Result",
                   html_table("Variables and figures, found and of the profile", {"", "found", "profile", "unit", "searched"}, rows) +
                       bullet_list(report.remarks));
}

/// Costs of infeasible springs and unbounded travels would flatten the curve.
double highest_shown(const CostCurve& curve) {
    const double least = *std::min_element(curve.cost.begin(), curve.cost.end());
    return least + std::max(0.5, std::abs(least));
}

std::string cost_plot(const CostCurve& curve) {
    const double top = highest_shown(curve);
    const auto shown = [top](double cost) { return cost <= top ? cost : kNoPoint; };
    std::vector<double> feasible, infeasible, lowest;
    for (std::size_t i = 0; i < curve.cost.size(); ++i) {
        feasible.push_back(curve.feasible[i] ? shown(curve.cost[i]) : kNoPoint);
        infeasible.push_back(curve.feasible[i] ? kNoPoint : shown(curve.cost[i]));
    }
    for (const double cost : curve.lowest_cost) lowest.push_back(shown(cost));
    Plot plot("Cost over " + curve.variable, with_unit(curve.variable, curve.unit), "cost");
    plot.curve("other variables at the optimum", curve.value, feasible, "exact");
    if (std::any_of(infeasible.begin(), infeasible.end(), [](double cost) { return std::isfinite(cost); }))
        plot.curve("infeasible", curve.value, infeasible, "pe", true);
    if (!lowest.empty()) plot.points("lowest of the search", curve.candidates, lowest, "linear");
    return plot.mark(curve.optimum, "optimum").svg();
}

std::string history_plot(const SearchReport& report) {
    std::vector<double> generation(report.history.size());
    for (std::size_t i = 0; i < generation.size(); ++i) generation[i] = static_cast<double>(i);
    return Plot("Best cost of each generation", "generation", "cost").curve("best cost", generation, report.history, "exact").svg();
}

std::string arm_plot(const CamCurve& cam) {
    using A = cam::ArmPoint;
    const std::string name = cam::to_string(cam.kind);
    return Plot("Lever arm of " + name, "cam angle [deg]", "arm [mm]")
        .curve("arm", column(cam.arms, [](const A& a) { return deg_from_rad(a.angle); }),
               column(cam.arms, [](const A& a) { return core::mm_from_m(a.arm); }), cam.kind == cam::PartKind::kSeries ? "se" : "pe")
        .from_zero()
        .svg();
}

/// Findings about the design found, passes left out.
std::vector<NumberedFinding> numbered_open_findings(const SearchReport& report) {
    std::vector<NumberedFinding> all;
    const auto add = [&all](const core::Findings& findings, const std::string& part) {
        for (const core::Finding& f : findings)
            if (f.severity != core::Severity::kPass) all.push_back({0, part, f});
    };
    add(report.findings, "law");
    for (const CamCurve& cam : report.cams) add(cam.findings, cam::to_string(cam.kind));
    return ranked(std::move(all));
}

}  // namespace

std::string costs_section(const SearchReport& report) {
    std::string charts;
    for (const CostCurve& curve : report.costs) charts += cost_plot(curve);
    return section("Cost", grid(charts + history_plot(report)));
}

std::string springs_section(const SearchReport& report) {
    using P = spring::LawPoint;
    using D = actuator::DeadBand;
    Plot torques("Both springs over the capstan angle", "capstan angle [rad]", "torque [Nm]");
    Plot band("Linear dead-band at the joint, edge to edge", kCoContractionAxis, "dead-band [deg]");
    const auto add = [&](const LawCurves& law, const std::string& whose, bool dashed) {
        const auto theta = column(law.samples, &P::theta);
        torques.curve("F_SE" + whose, theta, column(law.samples, &P::f_se), "se", dashed);
        torques.curve("F_PE" + whose, theta, column(law.samples, &P::f_pe), "pe", dashed);
        band.curve("found" + whose, column(law.dead_band, &D::tau),
                   column(law.dead_band, [](const D& d) { return deg_from_rad(d.linear); }), "linear", dashed);
    };
    add(report.found, "", false);
    if (!report.own.samples.empty()) add(report.own, ", profile", true);
    return section("Springs",
                   paragraph("Solid lines: the springs found; dashed: the springs of the profile.") +
                       grid(torques.from_zero().svg() + band.from_zero().svg()),
                   "spring-law");
}

std::string cams_section(const SearchReport& report) {
    if (report.cams.empty()) return section("Cams", paragraph("Not judged: the profile has no parts, or the law is refused."));
    const std::vector<NumberedFinding> findings = numbered_open_findings(report);
    std::string charts;
    for (const CamCurve& cam : report.cams) charts += arm_plot(cam);
    for (const CamCurve& cam : report.cams) {
        const std::string name = cam::to_string(cam.kind);
        charts += card("<h3 id=\"" + name + "\">" + name + "</h3>" +
                       (cam.part ? cam_svg(*cam.part, markers_of(findings, name))
                                 : paragraph("It cannot be cut for this base spring: see the findings.")));
    }
    return section("Cams", grid(charts));
}

std::string search_html(const SearchReport& report) {
    return html_page(report.provenance.name, search_head(report),
                     comparison_section(report) + costs_section(report) + springs_section(report) + cams_section(report) +
                         findings_section(numbered_open_findings(report)));
}

}  // namespace fusee::report
