#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/equilibrium.h"
#include "fusee/pipeline/simulate.h"
#include "pipeline/fixture.h"

// Equilibria that a caller asks for: any three torques, of the paper's joint and of its relatives.
namespace fusee::pipeline {
namespace {

namespace fs = std::filesystem;

Simulation simulated(const fs::path& path, const std::vector<Eigen::Vector3d>& at) {
    auto simulation = simulate(profile::read_profile(path), {.levels = 2, .at = at});
    if (!simulation) throw std::runtime_error(core::to_line(simulation.refusal().front()));
    return std::move(simulation).value();
}

TEST(SimulateEquilibrium, EqualTorquesStandWhereTheLawSays) {
    const profile::Profile profile = profile::read_profile(fixtures::shipped("first_prototype"));
    const actuator::Actuator actuator = resolve(profile)->actuator;
    const double tau = 0.7;
    const Simulation simulation = simulated(fixtures::shipped("first_prototype"), {{tau, tau, 0.0}});
    const EquilibriumRow& row = simulation.equilibria.at(0);
    const actuator::DeadBand d = actuator::dead_band(actuator, tau);
    // The search ends where 1e-14 of the torques is left over; the softest motion yields about 6 rad/Nm.
    EXPECT_NEAR(row.z[0], d.theta, 1e-12);
    EXPECT_NEAR(row.z[1], d.theta, 1e-12);
    EXPECT_NEAR(row.z[2], 0.0, 1e-12);
    EXPECT_NEAR(row.joint_stiffness, d.joint_stiffness, 1e-10 * d.joint_stiffness);
    EXPECT_NEAR(row.free_joint_stiffness, d.free_joint_stiffness, 1e-10 * d.free_joint_stiffness);
    ASSERT_TRUE(row.dead_band);
    EXPECT_NEAR(row.dead_band->linear, d.linear, 1e-10 * d.linear);
    EXPECT_NEAR(row.dead_band->exact_width, d.exact_width, 1e-9 * d.exact_width);
    EXPECT_NEAR(row.dead_band->condition_6[0], d.condition_6, 1e-9);
    EXPECT_NE(simulation.provenance.options.find(", at=0.7,0.7,0"), std::string::npos);
}

TEST(SimulateEquilibrium, SensitivityIsHowTheRestingPlaceMoves) {
    const Eigen::Vector3d torque(0.9, 0.7, 0.03);
    constexpr double kStep = 1e-4;
    std::vector<Eigen::Vector3d> at{torque};
    for (int j = 0; j < 3; ++j)
        for (const double side : {-kStep, kStep}) at.emplace_back(torque + side * Eigen::Vector3d::Unit(j));
    const auto rows = simulated(fixtures::shipped("first_prototype"), at).equilibria;
    for (int j = 0; j < 3; ++j) {
        const auto low = static_cast<std::size_t>(2 * j + 1);
        const Eigen::Vector3d moved = (rows[low + 1].z - rows[low].z) / (2.0 * kStep);
        for (int i = 0; i < 3; ++i)  // the error of central differences is of the order of the squared step
            EXPECT_NEAR(rows[0].sensitivity(i, j), moved[i], 1e-6 * rows[0].sensitivity.cwiseAbs().maxCoeff());
    }
    EXPECT_FALSE(rows[0].dead_band) << "defined without joint torque only";
    const double r_c = std::sqrt(rows[0].cable_space(0, 0) / rows[0].sensitivity(0, 0));
    EXPECT_NEAR(r_c, profile::read_profile(fixtures::shipped("first_prototype")).rig.capstan_radius, 1e-12) << "arc over force";
}

TEST(SimulateEquilibrium, TorquesBeyondTheLawsAreRefusedWithTheNearest) {
    const Simulation simulation = simulated(fixtures::shipped("pnrvsa"), {{1.0, 1.0, 0.0}, {5.0, 1.0, 0.0}});
    EXPECT_TRUE(simulation.equilibria[0].refusal.empty());
    EXPECT_TRUE(std::isnan(simulation.equilibria[1].z[0]));
    const core::Findings refusals = pipeline::refusals(simulation);
    ASSERT_FALSE(refusals.empty());
    EXPECT_EQ(refusals.front().rule, "equilibrium.outside");
    EXPECT_NE(refusals.front().where.find("at 5, 1, 0 Nm"), std::string::npos);
    EXPECT_NE(refusals.front().suggestion.text().find("tau_1 = "), std::string::npos);
}

TEST(SimulateEquilibrium, RelativesRestToo) {
    const fs::path path = fs::path(FUSEE_SOURCE_DIR) / "profiles/relatives/series_elastic.toml";
    const EquilibriumRow row = simulated(path, {{1.0, 0.0, 0.0}}).equilibria.at(0);
    const double loop = profile::read_profile(path).rig.position_stiffness;
    EXPECT_NEAR(row.z[0], 1.0 / loop, 1e-12) << "only the position loop holds the motor";
    EXPECT_EQ(row.z[1], 0.0) << "the second motor does not exist";
}

}  // namespace
}  // namespace fusee::pipeline
