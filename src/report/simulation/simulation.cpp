#include "fusee/report/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "data/csv.h"
#include "data/figures.h"
#include "design/parts.h"
#include "fusee/core/json.h"
#include "fusee/core/units.h"
#include "page/bundle.h"
#include "simulation/json.h"

namespace fusee::report {

namespace {

constexpr int kFigures = 5;
constexpr std::array<const char*, 3> kBodies{"theta_1", "theta_2", "q"};
constexpr const char* kCableSpace = "in cable space [m/N]";

/// A residual of the root search is shown as 0.
std::string angle(double rad) {
    constexpr double kNothing = 1e-12;
    return number(std::abs(rad) < kNothing ? 0.0 : rad, kFigures);
}
std::string degrees(double rad) { return angle(deg_from_rad(rad)); }

std::string torques_text(const Eigen::Vector3d& torque) {
    return fmt::format("tau_1 = {} Nm, tau_2 = {} Nm, tau_q = {} Nm", torque[0], torque[1], torque[2]);
}

std::string joint_width_text(const actuator::JointDeadBand& band) {
    const std::string exact = band.covered ? fmt::format("exact {} deg, q from {} to {} deg", deg(band.exact_width, kFigures),
                                                         degrees(band.edges.low), degrees(band.edges.high))
                                           : "exact unknown: a spring leaves its law before an edge";
    return fmt::format("linear {} deg; {}", deg(band.linear, kFigures), exact);
}

using Facts = std::vector<std::pair<std::string, std::string>>;

Facts facts_of(const EquilibriumRow& row) {
    Facts facts{{"equilibrium", fmt::format("theta_1 = {} rad, theta_2 = {} rad, q = {} rad ({} deg)", angle(row.z[0]), angle(row.z[1]),
                                            angle(row.z[2]), degrees(row.z[2]))},
                {"stiffness of the joint", fmt::format("{} Nm/rad capstans held, {} Nm/rad free", number(row.joint_stiffness, kFigures),
                                                       number(row.free_joint_stiffness, kFigures))}};
    if (!row.dead_band) {
        facts.emplace_back("dead-band", "defined without joint torque only");
        return facts;
    }
    const auto sides = [](const std::array<double, 2>& values) {
        return fmt::format("agonist {}, antagonist {}", number(values[0], kFigures), number(values[1], kFigures));
    };
    facts.emplace_back("dead-band", joint_width_text(*row.dead_band));
    facts.emplace_back("condition (5), own torque raised", sides(row.dead_band->condition_5));
    facts.emplace_back("condition (6), both torques raised", sides(row.dead_band->condition_6));
    return facts;
}

std::string matrix_text(const EquilibriumRow& row) {
    constexpr int kWide = 12;
    std::string text = fmt::format("    {:<50}{}\n", "sensitivity (2) to tau_1, tau_2, tau_q [rad/Nm]", kCableSpace);
    for (int i = 0; i < 3; ++i) {
        text += fmt::format("    {:8}", kBodies[static_cast<std::size_t>(i)]);
        for (const Eigen::Matrix3d* m : {&row.sensitivity, &row.cable_space}) {
            for (int j = 0; j < 3; ++j) text += fmt::format("{:>{}}", number((*m)(i, j), kFigures), kWide);
            text += "  ";
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += "\n";
    }
    return text;
}

/// The equilibria that were asked for, for a terminal.
std::string equilibria_text(const Simulation& s) {
    std::string text;
    for (const EquilibriumRow& row : s.equilibria) {
        text += fmt::format("  at {}\n", torques_text(row.torque));
        if (!row.refusal.empty()) {
            text += "    no equilibrium within the laws of the springs: " + row.refusal.front().rule + "\n";
            continue;
        }
        for (const auto& [name, value] : facts_of(row)) text += fmt::format("    {}: {}\n", name, value);
        text += matrix_text(row);
    }
    return text;
}

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
    return {{"verdict", to_string(condition_verdict(s.condition))},
            {"torques_Nm", range_json(s.condition.torques)},
            {"holds_Nm", json_list(s.condition.holds, range_json)},
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
    return json_list(points, [](const PathPoint& p) { return Json{p.joint_torque, p.q, p.load_1, p.load_2}; });
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

std::string simulation_text(const Simulation& s) {
    std::string text = fmt::format("{}\n  {:>8}  {:>10}  {:>10}  {:>10}  {:>13}  {:>13}  {:>11}\n", s.provenance.line(), "tau [Nm]",
                                   "linear", "exact", "measured", "condition (6)", "held [Nm/rad]", "capstan");
    for (const SimulatedLevel& level : s.levels) {
        const SimulatedDeadBand& d = level.dead_band;
        text +=
            fmt::format("  {:>8}  {:>10}  {:>10}  {:>10}  {:>13}  {:>13}  {:>11}\n", number(d.tau, 4), deg(d.linear), deg(d.exact_width),
                        deg(d.measured_width), number(d.condition_6, 3), number(d.joint_stiffness, 4), deg(d.theta));
    }
    for (const MeasuredRow& row : s.measured)
        text += fmt::format("  measured on the rig at {} Nm: {} deg; linear {}, exact {}, push and release {}\n", number(row.tau, 4),
                            deg(row.measured), deg(row.computed.linear), deg(row.computed.exact_width), deg(row.computed.measured_width));
    text += equilibria_text(s);
    for (const std::string& remark : remarks(s)) text += "  " + remark + "\n";
    for (const std::string& gap : s.gaps) text += "  not computed: " + gap + "\n";
    return text;
}

std::string survey_text(const std::vector<Simulation>& simulations) {
    std::string text = fmt::format("{:24} {:20} {:>18} {:>18} {:>12} {:>20}\n", "name", "arrangement", "held [Nm/rad]", "free [Nm/rad]",
                                   "torque [Nm]", "dead-band [deg]");
    for (const Simulation& s : simulations)
        text += fmt::format("{:24} {:20} {:>18} {:>18} {:>12} {:>20}\n", s.provenance.name, to_string(s.survey.arrangement),
                            span(s.survey.stiffness), span(s.survey.free_stiffness), number(s.survey.torque, 3),
                            span({deg_from_rad(s.survey.dead_band.low), deg_from_rad(s.survey.dead_band.high)}));
    return text;
}

std::string dead_band_csv(const std::vector<SimulatedLevel>& levels) {
    std::string csv = "tau_Nm,linear_rad,extreme_rad,protocol_rad,condition_6,joint_stiffness_Nm_per_rad,capstan_rad\n";
    for (const SimulatedLevel& level : levels) {
        const SimulatedDeadBand& d = level.dead_band;
        add_csv_row(csv, d.tau, d.linear, d.exact_width, d.measured_width, d.condition_6, d.joint_stiffness, d.theta);
    }
    return csv;
}

std::string relatives_csv(const std::vector<Simulation>& simulations) {
    std::string csv =
        "name,arrangement,stiffness_low_Nm_per_rad,stiffness_high_Nm_per_rad,free_stiffness_low_Nm_per_rad,free_stiffness_high_Nm_per_rad,"
        "torque_Nm,dead_band_low_rad,dead_band_high_rad\n";
    for (const Simulation& simulation : simulations) {
        const actuator::ArrangementRow& row = simulation.survey;
        add_csv_row(csv, simulation.provenance.name, to_string(row.arrangement), row.stiffness.low, row.stiffness.high,
                    row.free_stiffness.low, row.free_stiffness.high, row.torque, row.dead_band.low, row.dead_band.high);
    }
    return csv;
}

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
