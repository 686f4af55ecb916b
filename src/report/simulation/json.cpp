#include "simulation/json.h"

#include <algorithm>

#include "design/parts.h"
#include "fusee/core/json.h"
#include "page/bundle.h"

namespace fusee::report {

namespace {

Json matrix_json(const Eigen::Matrix3d& m) {
    Json rows = Json::array();
    for (int i = 0; i < 3; ++i) rows.push_back({m(i, 0), m(i, 1), m(i, 2)});
    return rows;
}

Json survey_json(const actuator::ArrangementRow& row) {
    return {{"arrangement", to_string(row.arrangement)},
            {"stiffness_Nm_per_rad", range_json(row.stiffness)},
            {"free_stiffness_Nm_per_rad", range_json(row.free_stiffness)},
            {"torque_Nm", row.torque},
            {"dead_band_rad", range_json(row.dead_band)},
            {"remark", row.remark}};
}

Json simulated_level_json(const SimulatedLevel& level) {
    const SimulatedDeadBand& d = level.dead_band;
    const actuator::ReleaseReading& r = level.reading;
    Json j{{"tau_Nm", d.tau}, {"linear_rad", d.linear}, {"exact_rad", d.exact_width}, {"measured_rad", d.measured_width}};
    j["protocol_rad"] = d.measured_width;  // old spelling; in `measured` rows it names another field than here
    j["condition_6"] = d.condition_6;
    j["joint_stiffness_Nm_per_rad"] = d.joint_stiffness;
    j["free_joint_stiffness_Nm_per_rad"] = d.free_joint_stiffness;
    j["capstan_rad"] = d.theta;
    j["push_torque_Nm"] = r.push_torque;
    j["full_push_Nm"] = r.full_push;
    j["covered_push_Nm"] = r.covered_push;
    j["covered_measured_rad"] = level.within_laws;
    j["q_low_rad"] = r.q_low;
    j["q_high_rad"] = r.q_high;
    j["frame_rad"] = level.frame;
    j["sensitivity_rad_per_Nm"] = matrix_json(level.sensitivity);
    j["noise_rad"] = {level.noise[0], level.noise[1], level.noise[2]};
    j["built_rad"] = range_json(level.built);
    return j;
}

Json condition_json(const Simulation& s) {
    Json holds = Json::array();
    for (const core::Range& part : s.condition.holds) holds.push_back(range_json(part));
    return {{"verdict", to_string(condition_verdict(s.condition))},
            {"torques_Nm", range_json(s.condition.torques)},
            {"holds_Nm", holds},
            {"values", range_json(s.condition.values)}};
}

/// A row of the measured table; `simulated_rad` is the width that the simulated test measures.
Json measured_json(const MeasuredRow& row) {
    const SimulatedDeadBand& d = row.computed;
    return {{"tau_Nm", d.tau},
            {"linear_rad", d.linear},
            {"exact_rad", d.exact_width},
            {"simulated_rad", d.measured_width},
            {"protocol_rad", d.measured_width},
            {"measured_rad", row.measured}};
}

Json points_json(const std::vector<PathPoint>& points) {
    Json all = Json::array();
    for (const PathPoint& p : points) all.push_back({p.joint_torque, p.q, p.load_1, p.load_2});
    return all;
}

Json path_json(const ReleasePath& path) {
    return {{"tau_Nm", path.tau},
            {"resting_loads_Nm", range_json(path.resting_loads)},
            {"up", points_json(path.up)},
            {"down", points_json(path.down)}};
}

Json equilibrium_json(const EquilibriumRow& row) {
    const auto three = [](const Eigen::Vector3d& v) { return Json::array({v[0], v[1], v[2]}); };
    Json j = {{"torques_Nm", three(row.torque)},
              {"z_rad", three(row.z)},
              {"sensitivity_rad_per_Nm", matrix_json(row.sensitivity)},
              {"cable_space_sensitivity_m_per_N", matrix_json(row.cable_space)},
              {"joint_stiffness_Nm_per_rad", row.joint_stiffness},
              {"free_joint_stiffness_Nm_per_rad", row.free_joint_stiffness},
              {"dead_band", Json()},
              {"findings", findings_json(row.refusal)}};
    if (const auto& band = row.dead_band)
        j["dead_band"] = {{"linear_rad", band->linear},
                          {"exact_rad", band->exact_width},
                          {"edges_rad", range_json(band->edges)},
                          {"condition_5", band->condition_5},
                          {"condition_6", band->condition_6}};
    return j;
}

}  // namespace

Json simulation_object(const Simulation& s) {
    Json j = provenance_json(s.provenance);
    j["made_by"] = s.provenance.line();
    j["survey"] = survey_json(s.survey);
    j["condition_6"] = condition_json(s);
    j["levels"] = json_list(s.levels, simulated_level_json);
    j["measured"] = json_list(s.measured, measured_json);
    j["equilibria"] = json_list(s.equilibria, equilibrium_json);
    j["path_columns"] = {"joint_torque_Nm", "q_rad", "load_1_Nm", "load_2_Nm"};
    j["path"] = s.path ? path_json(*s.path) : Json();
    j["loops"] = json_list(s.loops, [](const DeflectionLoop& loop) {
        return Json{{"tau_Nm", loop.tau}, {"cycle", points_json(loop.cycle)}};
    });
    j["break_away"] = json_list(s.break_away, [](const BreakAwayRow& row) {
        return Json{{"motor_torque_Nm", row.motor_torque}, {"loads_Nm", range_json(row.loads)}};
    });
    j["wrap_columns"] = {"tau_Nm", "give_loading_rad", "give_unloading_rad"};
    j["wraps"] = json_list(s.wraps, [](const WrapSide& side) {
        double widest = 0.0;
        for (const cam::WrapRow& row : side.loop.rows) widest = std::max(widest, row.width());
        return Json{{"part", cam::to_string(side.part)},
                    {"dissipated_J", side.loop.dissipated},
                    {"widest_rad", widest},
                    {"rows", json_list(side.loop.rows, [](const cam::WrapRow& row) {
                         return Json{row.tau, row.deflection_loading, row.deflection_unloading};
                     })}};
    });
    if (!s.stretches.empty())
        j["stretch"] = json_list(s.stretches, [](const StretchSide& side) {
            Json row{{"part", cam::to_string(side.part)}};
            row.update(stretch_json(side.at));
            return row;
        });
    j["bearing"] = {{"constant_Nm", s.bearing.constant}, {"tension_share", s.bearing.tension_share}};
    j["findings"] = findings_json(s.findings);
    j["remarks"] = remarks(s);
    j["not_known"] = s.gaps;
    return j;
}

std::string simulation_json(const Simulation& s) {
    Json j = simulation_object(s);
    core::keep_old_spelling(j, {{"extreme_rad", "exact_rad"},
                                {"covered_protocol_rad", "covered_measured_rad"},
                                {"hatted_sensitivity_m_per_N", "cable_space_sensitivity_m_per_N"}});
    j["renamed_fields"]["protocol_rad"] = "measured_rad; simulated_rad in `measured`";
    return json_text(std::move(j));
}

std::string simulation_html(const Simulation& s) {
    return page_file({"simulation", s.provenance.name, simulation_text(s), {{"result", simulation_json(s)}}});
}

}  // namespace fusee::report
