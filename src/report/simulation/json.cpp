#include "json/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "design/stretch.h"
#include "fusee/report/simulation.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;

Json range(const core::Range& r) { return Json::array({r.low, r.high}); }

Json matrix(const Eigen::Matrix3d& m) {
    Json rows = Json::array();
    for (int i = 0; i < 3; ++i) rows.push_back({m(i, 0), m(i, 1), m(i, 2)});
    return rows;
}

Json survey_json(const actuator::ArrangementRow& row) {
    return {{"arrangement", to_string(row.arrangement)},
            {"stiffness_Nm_per_rad", range(row.stiffness)},
            {"free_stiffness_Nm_per_rad", range(row.free_stiffness)},
            {"torque_Nm", row.torque},
            {"dead_band_rad", range(row.dead_band)},
            {"remark", row.remark}};
}

Json dead_band_json(const actuator::DeadBand& d) {
    return {{"tau_Nm", d.tau}, {"linear_rad", d.linear}, {"extreme_rad", d.exact_width}, {"protocol_rad", d.measured_width}};
}

Json level_json(const SimulatedLevel& level) {
    const actuator::DeadBand& d = level.dead_band;
    const actuator::ReleaseReading& r = level.reading;
    Json j = dead_band_json(d);
    j["condition_6"] = d.condition_6;
    j["joint_stiffness_Nm_per_rad"] = d.joint_stiffness;
    j["free_joint_stiffness_Nm_per_rad"] = d.free_joint_stiffness;
    j["capstan_rad"] = d.theta;
    j["push_torque_Nm"] = r.push_torque;
    j["full_push_Nm"] = r.full_push;
    j["covered_push_Nm"] = r.covered_push;
    j["covered_protocol_rad"] = level.within_laws;
    j["q_low_rad"] = r.q_low;
    j["q_high_rad"] = r.q_high;
    j["frame_rad"] = level.frame;
    j["sensitivity_rad_per_Nm"] = matrix(level.sensitivity);
    j["noise_rad"] = {level.noise[0], level.noise[1], level.noise[2]};
    j["built_rad"] = range(level.built);
    return j;
}

Json condition_json(const Simulation& s) {
    Json holds = Json::array();
    for (const core::Range& part : s.condition.holds) holds.push_back(range(part));
    return {{"verdict", to_string(condition_verdict(s))},
            {"torques_Nm", range(s.condition.torques)},
            {"holds_Nm", holds},
            {"values", range(s.condition.values)}};
}

Json measured_json(const MeasuredRow& row) {
    Json j = dead_band_json(row.computed);
    j["measured_rad"] = row.measured;
    return j;
}

Json points_json(const std::vector<PathPoint>& points) {
    Json all = Json::array();
    for (const PathPoint& p : points) all.push_back({p.joint_torque, p.q, p.load_1, p.load_2});
    return all;
}

Json path_json(const ReleasePath& path) {
    return {{"tau_Nm", path.tau},
            {"resting_loads_Nm", range(path.resting_loads)},
            {"up", points_json(path.up)},
            {"down", points_json(path.down)}};
}

Json equilibrium_json(const EquilibriumRow& row) {
    const auto three = [](const Eigen::Vector3d& v) { return Json::array({v[0], v[1], v[2]}); };
    Json j = {{"torques_Nm", three(row.torque)},
              {"z_rad", three(row.z)},
              {"sensitivity_rad_per_Nm", matrix(row.sensitivity)},
              {"hatted_sensitivity_m_per_N", matrix(row.cable_space)},
              {"joint_stiffness_Nm_per_rad", row.joint_stiffness},
              {"free_joint_stiffness_Nm_per_rad", row.free_joint_stiffness},
              {"dead_band", Json()},
              {"findings", findings_json(row.refusal)}};
    if (const auto& band = row.dead_band)
        j["dead_band"] = {{"linear_rad", band->linear},
                          {"extreme_rad", band->exact_width},
                          {"edges_rad", range(band->edges)},
                          {"condition_5", band->condition_5},
                          {"condition_6", band->condition_6}};
    return j;
}

/// One entry a row.
template <class Row, class ToJson>
Json listed(const std::vector<Row>& rows, const ToJson& to_json) {
    Json all = Json::array();
    for (const Row& row : rows) all.push_back(to_json(row));
    return all;
}

}  // namespace

std::string simulation_json(const Simulation& s) {
    Json j;
    j["fusee"] = core::version();
    j["name"] = s.provenance.name;
    j["profile_sha256"] = s.provenance.profile_sha256;
    j["options"] = s.provenance.options;
    j["survey"] = survey_json(s.survey);
    j["condition_6"] = condition_json(s);
    j["levels"] = listed(s.levels, level_json);
    j["measured"] = listed(s.measured, measured_json);
    j["equilibria"] = listed(s.equilibria, equilibrium_json);
    j["path_columns"] = {"joint_torque_Nm", "q_rad", "load_1_Nm", "load_2_Nm"};
    j["path"] = s.path ? path_json(*s.path) : Json();
    j["loops"] = listed(s.loops, [](const DeflectionLoop& loop) { return Json{{"tau_Nm", loop.tau}, {"cycle", points_json(loop.cycle)}}; });
    j["break_away"] = listed(s.break_away, [](const BreakAwayRow& row) {
        return Json{{"motor_torque_Nm", row.motor_torque}, {"loads_Nm", range(row.loads)}};
    });
    j["wraps"] = listed(s.wraps, [](const WrapSide& side) {
        double widest = 0.0;
        for (const cam::WrapRow& row : side.loop.rows) widest = std::max(widest, row.width());
        return Json{{"part", cam::to_string(side.part)}, {"dissipated_J", side.loop.dissipated}, {"widest_rad", widest}};
    });
    if (!s.stretches.empty())
        j["stretch"] = listed(s.stretches, [](const StretchSide& side) {
            Json row{{"part", cam::to_string(side.part)}};
            row.update(stretch_json(side.at));
            return row;
        });
    j["bearing"] = {{"constant_Nm", s.bearing.constant}, {"tension_share", s.bearing.tension_share}};
    j["findings"] = findings_json(s.findings);
    j["remarks"] = remarks(s);
    j["not_known"] = s.gaps;
    // A broken byte in a text is replaced rather than losing the report.
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fusee::report
