#include "fusee/core/json.h"

#include "fusee/report/paper.h"
#include "identification/json.h"
#include "page/bundle.h"
#include "page/column.h"
#include "search/json.h"
#include "simulation/json.h"

namespace fusee::report {

namespace {

Json noise_curve_json(const NoiseCurve& curve) {
    Json j{{"noise", curve.name},
           {"a_Nm_per_rad", curve.path.a},
           {"b_Nm_per_rad", curve.path.b},
           {"d_Nms_per_rad", curve.path.d},
           {"e_Nms_per_rad", curve.path.e},
           {"motor_inertia_kgm2", curve.path.motor_inertia},
           {"joint_inertia_kgm2", curve.path.joint_inertia},
           {"motor_noise_Nm2s", curve.path.motor_noise},
           {"joint_noise_Nm2s", curve.path.joint_noise}};
    if (!curve.refusal.empty()) {
        j["refusal"] = curve.refusal;
        return j;
    }
    j["monotone"] = curve.monotone();
    j["c_Nm_per_rad"] = curve.c;
    j["motor_variance_rad2"] = curve.motor;
    j["joint_variance_rad2"] = curve.joint;
    return j;
}

Json muscle_json(const paper::LinearMuscle& muscle) { return {{"k_se_Nm_per_rad", muscle.k_se}, {"k_pe_Nm_per_rad", muscle.k_pe}}; }

Json hill_json(const HillFigure& figure) {
    using Passive = HillFigure::Passive;
    return {{"series", muscle_json(figure.series)},
            {"parallel", muscle_json(figure.parallel)},
            {"largest_difference_Nm", figure.largest_difference()},
            {"rows", json_list(figure.rows,
                               [](const HillFigure::Row& row) {
                                   return Json{{"active_Nm", row.active},
                                               {"length_rad", row.length},
                                               {"series_Nm", row.series},
                                               {"parallel_Nm", row.parallel}};
                               })},
            {"passive", {{"length_rad", column(figure.passive, &Passive::length)}, {"force_Nm", column(figure.passive, &Passive::force)}}}};
}

Json paper_table_json(const PaperTable& table) {
    Json j{{"profile", table.simulation.provenance.name},
           {"profile_sha256", table.simulation.provenance.profile_sha256},
           {"condition_6", to_string(condition_verdict(table.simulation.condition))},
           {"implied_travel_rad", table.travel},
           {"rows", Json::array()}};
    for (std::size_t i = 0; i < table.simulation.measured.size(); ++i) {
        const MeasuredRow& row = table.simulation.measured[i];
        j["rows"].push_back({{"tau_Nm", row.tau},
                             {"paper_rad", row.measured},
                             {"linear_rad", row.computed.linear},
                             {"exact_rad", row.computed.exact_width},
                             {"measured_rad", row.computed.measured_width},
                             {"implied_parallel_Nm_per_rad", table.parallel[i]}});
    }
    return j;
}

Json figure_6_json(const Simulation& s) {
    if (!s.path) return nullptr;
    return {{"tau_Nm", s.path->tau}, {"q_low_rad", s.path->down.back().q}, {"q_high_rad", s.path->up.back().q}};
}

Json figure_8_json(const Identification& found) {
    const gap_case::FrictionLine& line = found.friction.trusted();
    return {{"file", found.name},           {"file_sha256", found.file_sha256},
            {"mu", line.through_zero_mu},   {"mu_95", range_json(line.through_zero_mu_95)},
            {"constant_Nm", line.constant}, {"constant_95_Nm", range_json(line.constant_95)}};
}

Json arrangement_json(const actuator::ArrangementRow& row) {
    return {{"stiffness_Nm_per_rad", range_json(row.stiffness)},
            {"free_stiffness_Nm_per_rad", range_json(row.free_stiffness)},
            {"torque_Nm", row.torque},
            {"dead_band_rad", range_json(row.dead_band)}};
}

}  // namespace

std::string paper_json(const Paper& paper) {
    Json j;
    j["fusee"] = core::version();
    j["made_by"] = paper.provenance.line();
    j["sources_sha256"] = paper.provenance.profile_sha256;
    j["claims"] = json_list(claims(paper), [](const PaperClaim& claim) {
        return Json{{"piece", claim.piece}, {"paper", claim.paper}, {"here", claim.here}};
    });
    j["figure_1"] = json_list(paper.figure_1, noise_curve_json);
    j["figure_2"] = hill_json(paper.figure_2);
    j["figure_6"] = figure_6_json(paper.table_1.simulation);
    j["figure_8"] = figure_8_json(paper.figure_8);
    j["figure_9"] = search_object(paper.figure_9);
    j["table_1"] = paper_table_json(paper.table_1);
    j["table_2"] = paper_table_json(paper.table_2);
    j["relatives"] = Json::array();
    for (std::size_t i = 0; i < paper.relatives.size(); ++i)
        j["relatives"].push_back({{"profile", paper.relatives[i].provenance.name},
                                  {"arrangement", to_string(paper.relatives[i].survey.arrangement)},
                                  {"profiled", arrangement_json(paper.relatives[i].survey)},
                                  {"torque_control", arrangement_json(paper.torque_control[i])}});
    core::keep_old_spelling(j, {{"extreme_rad", "exact_rad"}, {"protocol_rad", "measured_rad"}});
    j["figure_8"]["identification"] = identification_object(paper.figure_8);
    j["table_1"]["simulation"] = simulation_object(paper.table_1.simulation);
    j["table_2"]["simulation"] = simulation_object(paper.table_2.simulation);
    return json_text(std::move(j));
}

std::string paper_html(const Paper& paper) { return page_file({"paper", "paper", paper_text(paper), {{"result", paper_json(paper)}}}); }

}  // namespace fusee::report
