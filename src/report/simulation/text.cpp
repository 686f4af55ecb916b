#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "data/csv.h"
#include "data/figures.h"
#include "fusee/core/units.h"
#include "fusee/report/simulation.h"

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

}  // namespace fusee::report
