#include "data/json.h"

#include "search/page.h"

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
    return {{"part", cam::to_string(cam.kind)}, {"can_be_cut", cam.part.has_value()}, {"findings", findings_json(cam.findings)}};
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
            {"cams", json_list(report.cams, searched_cam_json)},
            {"findings", findings_json(report.findings)},
            {"remarks", report.remarks}};
}

std::string search_json(const SearchReport& report) { return json_text(search_object(report), {{"extreme_rad", "exact_rad"}}); }

}  // namespace fusee::report
