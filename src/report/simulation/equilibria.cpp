#include "simulation/equilibria.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "data/figures.h"
#include "fusee/core/units.h"

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

}  // namespace

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

}  // namespace fusee::report
