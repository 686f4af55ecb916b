#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "fusee/core/units.h"
#include "fusee/report/simulation.h"
#include "page/html.h"
#include "simulation/page.h"

namespace fusee::report {

namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;

constexpr int kDigits = 5;
constexpr std::array<const char*, 3> kBodies{"theta_1", "theta_2", "q"}, kTorques{"tau_1", "tau_2", "tau_q"};
constexpr const char* kMatrix = "sensitivity (2) [rad/Nm]";
constexpr const char* kHatted = "with hats, arcs over forces [m/N]";

/// What the search leaves of a joint that stands at 0 is shown as 0 [rad].
std::string angle(double rad) {
    constexpr double kNothing = 1e-12;
    return number(std::abs(rad) < kNothing ? 0.0 : rad, kDigits);
}
std::string degrees(double rad) { return angle(core::deg_from_rad(rad)); }

std::string torques_text(const Eigen::Vector3d& torque) {
    return fmt::format("tau_1 = {} Nm, tau_2 = {} Nm, tau_q = {} Nm", torque[0], torque[1], torque[2]);
}

std::string width_text(const actuator::JointDeadBand& band) {
    const std::string exact = band.covered
                                  ? fmt::format("exact {} deg, q from {} to {} deg", number(core::deg_from_rad(band.exact_width), kDigits),
                                                degrees(band.edges.low), degrees(band.edges.high))
                                  : "exact not known, since a spring leaves its law before an edge";
    return fmt::format("linear {} deg; {}", number(core::deg_from_rad(band.linear), kDigits), exact);
}

Facts facts_of(const EquilibriumRow& row) {
    Facts facts{{"rests at", fmt::format("theta_1 = {} rad, theta_2 = {} rad, q = {} rad ({} deg)", angle(row.z[0]), angle(row.z[1]),
                                         angle(row.z[2]), degrees(row.z[2]))},
                {"stiffness of the joint", fmt::format("{} Nm/rad capstans held, {} Nm/rad free", number(row.joint_stiffness, kDigits),
                                                       number(row.free_joint_stiffness, kDigits))}};
    if (!row.dead_band) {
        facts.emplace_back("dead-band", "defined without joint torque only");
        return facts;
    }
    const auto sides = [](const std::array<double, 2>& values) {
        return fmt::format("agonist {}, antagonist {}", number(values[0], kDigits), number(values[1], kDigits));
    };
    facts.emplace_back("dead-band", width_text(*row.dead_band));
    facts.emplace_back("condition (5), own torque raised", sides(row.dead_band->condition_5));
    facts.emplace_back("condition (6), both raised alike", sides(row.dead_band->condition_6));
    return facts;
}

std::string matrix_text(const EquilibriumRow& row) {
    constexpr int kWide = 12;
    std::string text = fmt::format("    {:<50}{}\n", "sensitivity (2) to tau_1, tau_2, tau_q [rad/Nm]", kHatted);
    for (int i = 0; i < 3; ++i) {
        text += fmt::format("    {:8}", kBodies[static_cast<std::size_t>(i)]);
        for (const Eigen::Matrix3d* m : {&row.sensitivity, &row.cable_space}) {
            for (int j = 0; j < 3; ++j) text += fmt::format("{:>{}}", number((*m)(i, j), kDigits), kWide);
            text += "  ";
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += "\n";
    }
    return text;
}

std::string matrix_table(const char* title, const Eigen::Matrix3d& m) {
    std::vector<std::string> head{title};
    head.insert(head.end(), kTorques.begin(), kTorques.end());
    std::vector<std::vector<Cell>> rows;
    for (int i = 0; i < 3; ++i) {
        std::vector<Cell>& cells = rows.emplace_back(std::vector<Cell>{{kBodies[static_cast<std::size_t>(i)], ""}});
        for (int j = 0; j < 3; ++j) cells.push_back({number(m(i, j), kDigits), "num"});
    }
    return html_table(head, rows);
}

}  // namespace

core::Findings refusals(const Simulation& simulation) {
    core::Findings all;
    for (const EquilibriumRow& row : simulation.equilibria) core::append(all, row.refusal);
    return all;
}

std::string equilibria_text(const Simulation& s) {
    std::string text;
    for (const EquilibriumRow& row : s.equilibria) {
        text += fmt::format("  at {}\n", torques_text(row.torque));
        if (!row.refusal.empty()) {
            text += "    the joint does not rest within its springs' laws: " + row.refusal.front().rule + "\n";
            continue;
        }
        for (const auto& [name, value] : facts_of(row)) text += fmt::format("    {}: {}\n", name, value);
        text += matrix_text(row);
    }
    return text;
}

std::string equilibria_section(const Simulation& s) {
    if (s.equilibria.empty()) return "";
    std::string out =
        "<section><h2>Equilibria asked for</h2><p>Capstan angles and torques are positive when they wind the own cable in, joint angle and "
        "torque when the agonist's cable is stretched. Matrices: d(theta_1, theta_2, q)/d(tau_1, tau_2, tau_q), the paper's (2).</p><div "
        "class=\"stack\">";
    for (const EquilibriumRow& row : s.equilibria) {
        out += "<h3>" + torques_text(row.torque) + "</h3>";
        for (const core::Finding& finding : row.refusal) out += "<p>" + escape(core::to_line(finding)) + "</p>";
        if (!row.refusal.empty()) continue;
        out += "<div class=\"card\">" + html_facts(facts_of(row)) + "</div><div class=\"grid\">" + matrix_table(kMatrix, row.sensitivity) +
               matrix_table(kHatted, row.cable_space) + "</div>";
    }
    return out + "</div></section>\n";
}

}  // namespace fusee::report
