#include "fusee/report/search.h"

#include "data/csv.h"
#include "design/parts.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "page/bundle.h"
#include "page/column.h"
#include "search/json.h"

namespace fusee::report {

namespace {

Json searched_levels_json(const std::vector<actuator::DeadBand>& levels) {
    return json_list(levels, [](const actuator::DeadBand& d) {
        return Json{{"tau_Nm", d.tau},
                    {"linear_rad", d.linear},
                    {"exact_rad", d.exact_width},
                    {"condition_6", d.condition_6},
                    {"joint_stiffness_Nm_per_rad", d.joint_stiffness}};
    });
}

Json variable_json(const SearchedVariable& v) {
    return {{"name", v.name}, {"unit", v.unit}, {"box", range_json(v.box)}, {"found", v.found}, {"own", v.own}};
}

Json compared_figure_json(const ComparedFigure& f) { return {{"name", f.name}, {"unit", f.unit}, {"found", f.found}, {"own", f.own}}; }

Json searched_cam_json(const CamCurve& cam) {
    return {{"part", cam::to_string(cam.kind)},
            {"can_be_cut", cam.part.has_value()},
            {"findings", findings_json(cam.findings)},
            {"arms", {{"angle_rad", column(cam.arms, &cam::ArmPoint::angle)}, {"arm_m", column(cam.arms, &cam::ArmPoint::arm)}}},
            {"drawing", cam.part ? drawing_json(*cam.part) : Json()}};
}

Json cost_json(const CostCurve& curve) {
    return {{"variable", curve.variable},
            {"unit", curve.unit},
            {"value", curve.value},
            {"cost", curve.cost},
            {"feasible", curve.feasible},
            {"candidates", curve.candidates},
            {"lowest_cost", curve.lowest_cost},
            {"optimum", curve.optimum}};
}

Json front_point_json(const ParetoPoint& p) {
    return {{"profile", p.file},
            {"figure_rad", p.figure},
            {"dead_band_rad", p.dead_band},
            {"travel_rad", p.travel},
            {"stiffness_Nm_per_rad", range_json(p.stiffness)},
            {"radius_mm", core::mm_from_m(p.radius)},
            {"capstan_radius_mm", core::mm_from_m(p.capstan_radius)},
            {"limited_by", p.limited_by}};
}

}  // namespace

Json search_object(const SearchReport& report) {
    return {{"made_by", report.provenance.line()},
            {"name", report.provenance.name},
            {"profile_sha256", report.provenance.profile_sha256},
            {"method", report.method},
            {"population", report.population},
            {"generations", report.generations},
            {"seed", report.seed},
            {"evaluations", report.evaluations},
            {"interrupted", report.interrupted},
            {"cost", report.cost},
            {"variables", json_list(report.variables, variable_json)},
            {"figures", json_list(report.figures, compared_figure_json)},
            {"dead_band", searched_levels_json(report.found.dead_band)},
            {"own_dead_band", searched_levels_json(report.own.dead_band)},
            {"springs", spring_curves_json(report.found.samples)},
            {"own_springs", spring_curves_json(report.own.samples)},
            {"costs", json_list(report.costs, cost_json)},
            {"history", report.history},
            {"cams", json_list(report.cams, searched_cam_json)},
            {"findings", findings_json(report.findings)},
            {"remarks", report.remarks}};
}

std::string search_html(const SearchReport& report, const std::string& summary) {
    return page_file({"search", report.provenance.name, summary, {{"result", search_json(report)}}});
}

std::string pareto_json(const ParetoReport& report) {
    Json j = provenance_json(report.provenance);
    j["made_by"] = report.provenance.line();
    j["against"] = report.against_size ? "size" : "travel";
    j["loads_Nm"] = range_json(report.loads);
    j["torques_Nm"] = report.torques;
    j["points"] = json_list(report.points, front_point_json);
    j["dropped"] = report.dropped;
    j["dropped_by"] = report.dropped_by;
    j["population"] = report.population;
    j["generations"] = report.generations;
    j["seed"] = report.seed;
    j["evaluations"] = report.evaluations;
    j["interrupted"] = report.interrupted;
    return json_text(std::move(j));
}

std::string pareto_html(const ParetoReport& report, const std::string& summary) {
    return page_file({"pareto", report.provenance.name, summary, {{"result", pareto_json(report)}}});
}

std::string search_json(const SearchReport& report) { return json_text(search_object(report), {{"extreme_rad", "exact_rad"}}); }

void write_search(const search::codesign::RunResult& result, const fs::path& folder) {
    for (const search::codesign::FoundProfile& profile : result.profiles) {
        core::make_folder((folder / profile.file).parent_path());
        core::write_file(folder / profile.file, profile.toml);
    }
    std::string summary;
    for (const std::string& line : result.summary) summary += line + "\n";
    if (const auto& search = result.search) {
        core::write_file(folder / "history.csv", history_csv(search->history));
        if (!search->costs.empty()) core::write_file(folder / "figure_9.csv", figure_9_csv(search->costs));
        core::write_file(folder / "design.json", search_json(*search));
        core::write_file(folder / "design.html", search_html(*search, summary));
    }
    if (const auto& pareto = result.pareto) {
        core::write_file(folder / "pareto.json", pareto_json(*pareto));
        core::write_file(folder / "pareto.csv", pareto_csv(*pareto));
        core::write_file(folder / "pareto.html", pareto_html(*pareto, summary));
    }
}

std::string figure_9_csv(const std::vector<CostCurve>& costs) {
    std::string csv = "variable,value,cost,feasible\n";
    for (const CostCurve& curve : costs)
        for (std::size_t i = 0; i < curve.value.size(); ++i)
            add_csv_row(csv, curve.variable, curve.value[i], curve.cost[i], curve.feasible[i] ? 1 : 0);
    return csv;
}

std::string history_csv(const std::vector<double>& history) {
    std::string csv = "generation,best_cost\n";
    for (std::size_t i = 0; i < history.size(); ++i) add_csv_row(csv, i, history[i]);
    return csv;
}

std::string pareto_csv(const ParetoReport& report) {
    std::string csv = "profile,figure_deg";
    for (const double torque : report.torques) csv += fmt::format(",dead_band_at_{:g}_Nm_deg", torque);
    csv += ",travel_rad,soft_Nm_per_rad,stiff_Nm_per_rad,radius_mm,capstan_radius_mm\n";
    for (const ParetoPoint& p : report.points) {
        csv += fmt::format("{},{:.17g}", p.file, core::deg_from_rad(p.figure));
        for (const double width : p.dead_band) csv += fmt::format(",{:.17g}", core::deg_from_rad(width));
        csv += ",";
        add_csv_row(csv, p.travel, p.stiffness.low, p.stiffness.high, core::mm_from_m(p.radius), core::mm_from_m(p.capstan_radius));
    }
    return csv;
}

}  // namespace fusee::report
