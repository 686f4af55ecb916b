#include "fusee/report/paper.h"

#include "data/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/json.h"
#include "fusee/core/units.h"
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

void write_paper(const Paper& paper, const fs::path& folder) {
    const auto write = [&folder](const char* name, const std::string& bytes) { core::write_file(folder / name, bytes); };
    write("figure_1.csv", figure_1_csv(paper.figure_1));
    write("figure_2.csv", figure_2_csv(paper.figure_2));
    write("figure_2_passive.csv", figure_2_passive_csv(paper.figure_2));
    if (paper.table_1.simulation.path) write("figure_6.csv", figure_6_csv(*paper.table_1.simulation.path));
    write("figure_8.csv", figure_8_csv(paper.figure_8));
    write("figure_9.csv", figure_9_csv(paper.figure_9.costs));
    write("figure_9_springs.csv", figure_9_springs_csv(paper.figure_9.found));
    write("figure_9_arms.csv", figure_9_arms_csv(paper.figure_9.cams));
    write("table_1.csv", table_csv(paper.table_1));
    write("table_2.csv", table_csv(paper.table_2));
    write("relatives.csv", relatives_csv(paper.relatives));
    write("paper.json", paper_json(paper));
    write("paper.html", paper_html(paper));
}

std::string figure_1_csv(const std::vector<NoiseCurve>& curves) {
    std::string csv = "noise,c_Nm_per_rad,motor_variance_rad2,joint_variance_rad2,joint_slope_rad3_per_Nm\n";
    for (const NoiseCurve& curve : curves)
        for (std::size_t i = 0; i < curve.c.size(); ++i)
            add_csv_row(csv, curve.name, curve.c[i], curve.motor[i], curve.joint[i], curve.slope[i]);
    return csv;
}

std::string figure_2_csv(const HillFigure& figure) {
    std::string csv = "active_Nm,length_rad,series_Nm,parallel_Nm\n";
    for (const HillFigure::Row& row : figure.rows) add_csv_row(csv, row.active, row.length, row.series, row.parallel);
    return csv;
}

std::string figure_2_passive_csv(const HillFigure& figure) {
    std::string csv = "length_rad,force_Nm\n";
    for (const HillFigure::Passive& p : figure.passive) add_csv_row(csv, p.length, p.force);
    return csv;
}

std::string figure_6_csv(const ReleasePath& path) {
    std::string csv = "push,joint_torque_Nm,q_rad,load_1_Nm,load_2_Nm\n";
    const auto add = [&csv](const char* push, const std::vector<PathPoint>& points) {
        for (const PathPoint& p : points) add_csv_row(csv, push, p.joint_torque, p.q, p.load_1, p.load_2);
    };
    add("up", path.up);
    add("down", path.down);
    return csv;
}

std::string figure_8_csv(const Identification& identification) {
    std::string csv = "side,direction,motor_torque_Nm,rows,mean_load_Nm,mean_friction_Nm,deviation_Nm\n";
    for (const gap_case::FrictionReport::Repeat& r : identification.friction.repeats)
        add_csv_row(csv, r.side, r.backdrive ? "backdrive" : "drive", r.motor_torque, r.rows, r.mean_load, r.mean_friction, r.deviation);
    return csv;
}

std::string figure_9_springs_csv(const LawCurves& law) {
    std::string csv = "tau_Nm,theta_rad,f_se_Nm,f_pe_Nm,s_Nm_per_rad,p_Nm_per_rad\n";
    for (const spring::LawPoint& p : law.samples) add_csv_row(csv, p.tau, p.theta, p.f_se, p.f_pe, p.s, p.p);
    return csv;
}

std::string figure_9_arms_csv(const std::vector<CamCurve>& cams) {
    std::string csv = "part,cam_angle_rad,arm_m\n";
    for (const CamCurve& cam : cams)
        for (const cam::ArmPoint& p : cam.arms) add_csv_row(csv, cam::to_string(cam.kind), p.angle, p.arm);
    return csv;
}

std::string table_csv(const PaperTable& table) {
    std::string csv =
        "tau_Nm,paper_deg,linear_deg,extreme_deg,protocol_deg,linear_less_paper_deg,extreme_less_paper_deg,protocol_less_paper_deg,"
        "implied_parallel_Nm_per_rad\n";
    for (std::size_t i = 0; i < table.simulation.measured.size(); ++i) {
        const MeasuredRow& row = table.simulation.measured[i];
        const SimulatedDeadBand& d = row.computed;
        add_csv_row(csv, row.tau, core::deg_from_rad(row.measured), core::deg_from_rad(d.linear), core::deg_from_rad(d.exact_width),
                    core::deg_from_rad(d.measured_width), core::deg_from_rad(d.linear - row.measured),
                    core::deg_from_rad(d.exact_width - row.measured), core::deg_from_rad(d.measured_width - row.measured),
                    table.parallel[i]);
    }
    return csv;
}

}  // namespace fusee::report
