#include "json/json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fusee/report/search.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;

Json variables_json(const std::vector<SearchedVariable>& variables) {
    Json all = Json::array();
    for (const SearchedVariable& v : variables)
        all.push_back({{"name", v.name}, {"unit", v.unit}, {"box", {v.box.low, v.box.high}}, {"found", v.found}, {"own", v.own}});
    return all;
}

Json figures_json(const std::vector<ComparedFigure>& figures) {
    Json all = Json::array();
    for (const ComparedFigure& f : figures) all.push_back({{"name", f.name}, {"unit", f.unit}, {"found", f.found}, {"own", f.own}});
    return all;
}

Json dead_band_json(const std::vector<actuator::DeadBand>& levels) {
    Json all = Json::array();
    for (const actuator::DeadBand& d : levels)
        all.push_back({{"tau_Nm", d.tau},
                       {"linear_rad", d.linear},
                       {"extreme_rad", d.exact_width},
                       {"condition_6", d.condition_6},
                       {"joint_stiffness_Nm_per_rad", d.joint_stiffness}});
    return all;
}

Json cams_json(const std::vector<CamCurve>& cams) {
    Json all = Json::array();
    for (const CamCurve& cam : cams)
        all.push_back(
            {{"part", cam::to_string(cam.kind)}, {"can_be_cut", cam.part.has_value()}, {"findings", findings_json(cam.findings)}});
    return all;
}

}  // namespace

std::string search_json(const SearchReport& report) {
    const Json j{{"made_by", report.provenance.line()},
                 {"name", report.provenance.name},
                 {"profile_sha256", report.provenance.profile_sha256},
                 {"method", report.method},
                 {"population", report.population},
                 {"generations", report.generations},
                 {"seed", report.seed},
                 {"evaluations", report.evaluations},
                 {"interrupted", report.interrupted},
                 {"cost", report.cost},
                 {"variables", variables_json(report.variables)},
                 {"figures", figures_json(report.figures)},
                 {"dead_band", dead_band_json(report.found.dead_band)},
                 {"own_dead_band", dead_band_json(report.own.dead_band)},
                 {"cams", cams_json(report.cams)},
                 {"findings", findings_json(report.findings)},
                 {"remarks", report.remarks}};
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string figure_9_csv(const std::vector<CostCurve>& costs) {
    std::string csv = "variable,value,cost,feasible\n";
    for (const CostCurve& curve : costs)
        for (std::size_t i = 0; i < curve.value.size(); ++i)
            csv += fmt::format("{},{:.17g},{:.17g},{}\n", curve.variable, curve.value[i], curve.cost[i], curve.feasible[i] ? 1 : 0);
    return csv;
}

std::string history_csv(const std::vector<double>& history) {
    std::string csv = "generation,best_cost\n";
    for (std::size_t i = 0; i < history.size(); ++i) csv += fmt::format("{},{:.17g}\n", i, history[i]);
    return csv;
}

}  // namespace fusee::report
