#include "search/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "design/page.h"
#include "fusee/report/search.h"
#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

using core::deg_from_rad;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string with_unit(const std::string& name, const std::string& unit) { return unit.empty() ? name : name + " [" + unit + "]"; }

bool can_be_cut(const SearchReport& report) {
    return std::all_of(report.cams.begin(), report.cams.end(), [](const CamCurve& cam) { return cam.part.has_value(); }) &&
           !core::any_error(report.findings);
}

std::string verdict_tag(const SearchReport& report) {
    if (report.cams.empty()) return "<span class=\"verdict pass-tag\">\u2713 Springs found</span>";
    return can_be_cut(report) ? "<span class=\"verdict pass-tag\">\u2713 Springs found, and their cams can be made</span>"
                              : "<span class=\"verdict review-tag\">! Springs found, but not for these base springs</span>";
}

std::string head(const SearchReport& report) {
    std::string out = "<header><p class=\"eyebrow\">fusee spring design</p><h1>" + escape(report.provenance.name) + "</h1>" +
                      verdict_tag(report) + "<p class=\"stamp\">" + escape(report.provenance.line()) + "</p><div class=\"tiles\">";
    for (const SearchedVariable& v : report.variables) out += html_tile(number(v.found), with_unit(v.name, v.unit));
    out += html_tile(number(report.cost), "cost");
    const std::string ended = report.interrupted ? ", stopped early" : "";
    return out +
           html_tile(fmt::format("{}", report.evaluations),
                     fmt::format("evaluations in {} generations{}, seed {}", report.generations, ended, report.seed)) +
           "</div></header>\n";
}

std::string comparison(const SearchReport& report) {
    std::vector<std::vector<Cell>> rows;
    for (const SearchedVariable& v : report.variables)
        rows.push_back({{escape(v.name), ""},
                        {number(v.found, 5), "num"},
                        {number(v.own, 5), "num"},
                        {escape(v.unit), ""},
                        {number(v.box.low) + " to " + number(v.box.high), "num"}});
    for (const ComparedFigure& f : report.figures)
        rows.push_back({{escape(f.name), ""}, {number(f.found, 5), "num"}, {number(f.own, 5), "num"}, {escape(f.unit), ""}, {"", ""}});
    std::string out = "<section><h2>What was found</h2>" + html_table({"", "found", "profile's own", "unit", "searched"}, rows);
    if (report.remarks.empty()) return out + "</section>\n";
    out += "<ul>";
    for (const std::string& remark : report.remarks) out += "<li>" + escape(remark) + "</li>";
    return out + "</ul></section>\n";
}

/// Costs of springs that are none, or of travels without end, would flatten the valley.
double highest_shown(const CostCurve& curve) {
    const double least = *std::min_element(curve.cost.begin(), curve.cost.end());
    return least + std::max(0.5, std::abs(least));
}

std::string cost_plot(const CostCurve& curve) {
    const double top = highest_shown(curve);
    const auto shown = [top](double cost) { return cost <= top ? cost : kNan; };
    std::vector<double> springs, none, tried;
    for (std::size_t i = 0; i < curve.cost.size(); ++i) {
        springs.push_back(curve.feasible[i] ? shown(curve.cost[i]) : kNan);
        none.push_back(curve.feasible[i] ? kNan : shown(curve.cost[i]));
    }
    for (const double cost : curve.lowest_cost) tried.push_back(shown(cost));
    Plot plot("Cost over " + curve.variable, with_unit(curve.variable, curve.unit), "cost");
    plot.curve("others at the optimum", curve.value, springs, "exact");
    if (std::any_of(none.begin(), none.end(), [](double cost) { return std::isfinite(cost); }))
        plot.curve("no springs", curve.value, none, "pe", true);
    if (!tried.empty()) plot.points("lowest tried", curve.tried, tried, "linear");
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

/// What the rules say against the law found; what holds is left out.
std::vector<NumberedFinding> broken(const SearchReport& report) {
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
    std::string out = "<section><h2>Cost</h2><div class=\"grid\">";
    for (const CostCurve& curve : report.costs) out += cost_plot(curve);
    return out + history_plot(report) + "</div></section>\n";
}

std::string springs_section(const SearchReport& report) {
    using P = spring::LawPoint;
    using D = actuator::DeadBand;
    Plot torques("Both springs over the capstan's angle", "capstan angle [rad]", "torque [Nm]");
    Plot band("Linear dead-band at the joint, edge to edge", "co-contraction, motor torque at the capstan [Nm]", "dead-band [deg]");
    const auto add = [&](const LawCurves& law, const std::string& whose, bool dashed) {
        const auto theta = column(law.samples, [](const P& p) { return p.theta; });
        torques.curve("F_SE" + whose, theta, column(law.samples, [](const P& p) { return p.f_se; }), "se", dashed);
        torques.curve("F_PE" + whose, theta, column(law.samples, [](const P& p) { return p.f_pe; }), "pe", dashed);
        const auto tau = column(law.dead_band, [](const D& d) { return d.tau; });
        band.curve("found" + whose, tau, column(law.dead_band, [](const D& d) { return deg_from_rad(d.linear); }), "linear", dashed);
    };
    add(report.found, "", false);
    if (!report.own.samples.empty()) add(report.own, ", own", true);
    return "<section><h2>Springs</h2><p>Whole lines: the springs found; dashed: those of the profile.</p><div class=\"grid\">" +
           torques.from_zero().svg() + band.from_zero().svg() + "</div></section>\n";
}

std::string cams_section(const SearchReport& report) {
    if (report.cams.empty()) return "<section><h2>Cams</h2><p>Not judged: the profile has no parts, or the law is refused.</p></section>\n";
    const std::vector<NumberedFinding> findings = broken(report);
    std::string out = "<section><h2>Cams</h2><div class=\"grid\">";
    for (const CamCurve& cam : report.cams) out += arm_plot(cam);
    for (const CamCurve& cam : report.cams) {
        const std::string name = cam::to_string(cam.kind);
        out +=
            "<div class=\"card\"><h3>" + name + "</h3>" +
            (cam.part ? cam_svg(*cam.part, markers_of(findings, name)) : "<p>It cannot be cut on this base spring: see the findings.</p>") +
            "</div>";
    }
    return out + "</div></section>\n";
}

std::string search_html(const SearchReport& report) {
    return html_page(report.provenance.name, head(report) + comparison(report) + costs_section(report) + springs_section(report) +
                                                 cams_section(report) + findings_section(broken(report)));
}

}  // namespace fusee::report
