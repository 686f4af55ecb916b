#include "fusee/pipeline/simulate.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/headline.h"
#include "fusee/report/simulation.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

namespace fs = std::filesystem;

class Simulate : public fixtures::TempFolder {
protected:
    profile::Profile changed(const std::string& name, const fixtures::Changes& changes) const {
        lay_tables();
        return profile::read_profile(write("t.toml", fixtures::with_keys(core::read_file(fixtures::shipped(name)), changes)));
    }
    static Simulation simulated(const profile::Profile& profile, const SimulateOptions& options = {}) {
        auto simulation = simulate(profile, options);
        if (!simulation) throw std::runtime_error(core::to_line(simulation.refusal().front()));
        return std::move(simulation).value();
    }
};

std::vector<std::vector<double>> rows_of(const std::string& csv) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::vector<double>& row = rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    }
    return rows;
}

TEST_F(Simulate, LevelsAreTheActuatorsDeadBands) {
    const profile::Profile profile = profile::read_profile(fixtures::shipped("pnrvsa"));
    const Simulation simulation = simulated(profile, {.levels = 5});
    ASSERT_EQ(simulation.levels.size(), 5u);
    EXPECT_EQ(simulation.levels.front().dead_band.tau, 0.85);
    EXPECT_EQ(simulation.levels.back().dead_band.tau, 1.5);
    const actuator::Actuator joint = resolve(profile)->actuator;
    for (const SimulatedLevel& level : simulation.levels) {
        const actuator::DeadBand d = actuator::dead_band(joint, level.dead_band.tau);
        EXPECT_EQ(level.dead_band.linear, d.linear);
        EXPECT_EQ(level.dead_band.exact_width, d.exact_width);
        EXPECT_EQ(level.dead_band.measured_width, level.reading.width());
        EXPECT_LE(level.dead_band.measured_width, level.dead_band.exact_width * 1.0001) << "no test reads beyond the extremes";
        EXPECT_GT(level.dead_band.measured_width, 0.0);
        EXPECT_NEAR(level.frame, 0.0, 1e-12) << "no gear and no bearing friction";
        EXPECT_LT(level.built.low, d.exact_width);
        EXPECT_GT(level.built.high, d.exact_width);
        EXPECT_NEAR(level.sensitivity(2, 2), 1.0 / d.free_joint_stiffness, 1e-6 / d.free_joint_stiffness)
            << "dq/dtau_q, both capstans free";
    }
    EXPECT_EQ(condition_verdict(simulation.condition), ConditionVerdict::kWithinRounding) << "u of 1.2 mNm: by 2e-6 at the most";
    EXPECT_NE(report::simulation_text(simulation).find("up to a joint torque of 0.151 Nm."), std::string::npos);
    EXPECT_NE(report::simulation_text(simulation).find("not computed: hysteresis of the cables on their cams: state cable.friction"),
              std::string::npos);
    EXPECT_LT(simulation.levels.back().noise[2], simulation.levels.front().noise[2]) << "co-contraction rejects noise";
}

TEST_F(Simulate, TheFirstPrototypeFailsTheConditionAndGrowsAsTableI) {
    const Simulation simulation = simulated(profile::read_profile(fixtures::shipped("first_prototype")), {.levels = 4});
    EXPECT_EQ(condition_verdict(simulation.condition), ConditionVerdict::kFails);
    ASSERT_EQ(simulation.measured.size(), 4u);
    for (std::size_t i = 1; i < simulation.measured.size(); ++i) {
        EXPECT_GT(simulation.measured[i].measured, simulation.measured[i - 1].measured);
        EXPECT_GT(simulation.measured[i].computed.linear, simulation.measured[i - 1].computed.linear);
    }
    EXPECT_NEAR(core::deg_from_rad(simulation.measured[1].measured), 27.9, 1e-12);
    EXPECT_NEAR(core::deg_from_rad(simulation.measured[1].computed.linear), 27.9, 0.3) << "the springs were chosen to meet this row";
}

TEST_F(Simulate, TheNewSpringsFallAsTableII) {
    const auto of = [](const char* name) {
        return simulated(profile::read_profile(fs::path(FUSEE_SOURCE_DIR) / "profiles" / "paper" / name), {.levels = 3});
    };
    const Simulation designed = of("new_springs.toml"), wanted = of("as_measured.toml");
    EXPECT_EQ(condition_verdict(designed.condition), ConditionVerdict::kHolds);
    for (const Simulation* s : {&designed, &wanted}) {
        ASSERT_EQ(s->measured.size(), 5u);
        for (std::size_t i = 1; i < s->measured.size(); ++i) EXPECT_LT(s->measured[i].computed.linear, s->measured[i - 1].computed.linear);
    }
    for (const MeasuredRow& row : wanted.measured)  // springs made from the dead-band leave it
        EXPECT_NEAR(row.computed.linear, row.measured, 1e-8 * row.measured);
}

TEST_F(Simulate, BearingFrictionAloneLeavesADeadBandThatVanishesWithLoad) {
    const Simulation simulation = simulated(changed("first_prototype", {{"rig.joint_friction_Nm", "0.002"}}), {.levels = 3});
    const auto& levels = simulation.levels;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        EXPECT_GT(levels[i].frame, 0.0);
        EXPECT_NEAR(levels[i].frame, 2.0 * 0.002 / levels[i].dead_band.free_joint_stiffness, 0.05 * levels[i].frame)
            << "capstans free to turn: 2 c over the free stiffness, which changes a little within it";
        EXPECT_TRUE(i == 0 || levels[i].frame < levels[i - 1].frame);
        EXPECT_LT(levels[i].frame, 0.2 * levels[i].dead_band.exact_width) << "small compared with the gears";
    }
}

TEST_F(Simulate, PathsStayWithinFrictionAndLoopsClose) {
    const Simulation simulation = simulated(profile::read_profile(fixtures::shipped("first_prototype")), {.levels = 2});
    ASSERT_TRUE(simulation.path);
    const ReleasePath& path = *simulation.path;
    for (const auto* half : {&path.up, &path.down})
        for (const PathPoint& p : *half)
            for (const double load : {p.load_1, p.load_2}) {
                EXPECT_GE(load, path.resting_loads.low * (1.0 - 1e-6));
                EXPECT_LE(load, path.resting_loads.high * (1.0 + 1e-6));
            }
    EXPECT_EQ(path.up.back().joint_torque, 0.0);
    EXPECT_GT(path.up.back().q, path.down.back().q);
    ASSERT_EQ(simulation.loops.size(), 2u) << "the least, the middle and the greatest level, each once";
    for (const DeflectionLoop& loop : simulation.loops)
        EXPECT_NEAR(loop.cycle.front().q, loop.cycle.back().q, 1e-6 * std::abs(loop.cycle.back().q));
}

/// The rate at which (k, u, C) springs take stiction from the joint is u^2/tau^2 for any gear: they are made for the friction at
/// rest.
TEST_F(Simulate, StictionCompensationIsMadeForTheFrictionAtRest) {
    const Simulation simulation = simulated(changed("pnrvsa", {{"rig.gear_friction_rest_excess", "0.1"}}), {.levels = 3});
    ASSERT_EQ(simulation.levels.size(), 3u);
    for (const SimulatedLevel& level : simulation.levels) {
        const double tau = level.dead_band.tau, wanted = -0.0012 * 0.0012 / (tau * tau);
        EXPECT_NEAR(level.dead_band.condition_6, wanted, 1e-6 * -wanted) << tau;  // T + tau T' leaves 1e-9 of 0.07
    }
}

TEST_F(Simulate, PathsAreThoseOfTheExactSprings) {
    for (const char* name : {"pnrvsa", "first_prototype"}) {
        const auto design = resolve(profile::read_profile(fixtures::shipped(name)));
        const actuator::ReleaseTest test{.push_torque = 0.3, .find_full_push = false};
        const auto exact = actuator::release_test(joint_of(*design), 1.0, test);
        const auto tabulated = actuator::release_test(path_joint_of(*design), 1.0, test);
        ASSERT_GT(exact.width(), 0.0);
        // Torques that are tabulated to 1e-12 move a place by that over the stiffness; the search itself leaves 1e-11 Nm.
        EXPECT_NEAR(tabulated.q_high, exact.q_high, 1e-9) << name;
        EXPECT_NEAR(tabulated.q_low, exact.q_low, 1e-9) << name;
    }
}

TEST_F(Simulate, MotorSubsystemIsTheGearsFriction) {
    const Simulation simulation =
        simulated(changed("first_prototype", {{"rig.gear_friction_constant_Nm", "0.01"}, {"rig.gear_friction", "0.2"}}), {.levels = 2});
    for (const BreakAwayRow& row : simulation.break_away) {
        EXPECT_NEAR(row.loads.high - row.motor_torque, 0.01 + 0.2 * row.loads.high, 1e-12);
        EXPECT_NEAR(row.motor_torque - row.loads.low, 0.01 + 0.2 * std::abs(row.loads.low), 1e-12);
    }
}

TEST_F(Simulate, AWeakPushReadsLessAndSaysSo) {
    const profile::Profile profile = profile::read_profile(fixtures::shipped("first_prototype"));
    const Simulation strong = simulated(profile, {.levels = 2}), weak = simulated(profile, {.levels = 2, .push_torque = 0.05});
    EXPECT_LT(weak.levels.front().dead_band.measured_width, 0.9 * strong.levels.front().dead_band.measured_width);
    std::string words;
    for (const std::string& remark : report::remarks(weak)) words += remark + "\n";
    EXPECT_NE(words.find("too weak"), std::string::npos) << words;
}

TEST_F(Simulate, EveryKindOfLawAndFriction) {
    const std::string pnrvsa = core::read_file(fixtures::shipped("pnrvsa"));
    const auto dead_band_at_1 = [&](const fixtures::Changes& changes) {
        const profile::Profile profile = profile::read_profile(write("k.toml", fixtures::with_keys(pnrvsa, changes)));
        const auto design = resolve(profile);
        EXPECT_TRUE(design) << core::to_line(design.refusal().front());
        return actuator::dead_band(design->actuator, 1.0);
    };
    const double mu_alone = dead_band_at_1({}).condition_6;
    const actuator::DeadBand affine = dead_band_at_1({{"rig.gear_friction_constant_Nm", "0.01"}});
    EXPECT_NEAR(affine.condition_6, mu_alone, 1e-9) << "-u^2/tau^2 for any friction: (k, u, C) is made for it";
    write("gear.csv", "load_Nm,friction_Nm\n0.0,0.01\n1.0,0.29\n2.0,0.57\n4.0,1.13\n");
    std::string tabulated = pnrvsa;
    const std::string line = "gear_friction = 0.28 ";
    tabulated.replace(tabulated.find(line), line.size(), "gear_friction_table = \"gear.csv\" ");
    const profile::Profile table = profile::read_profile(write("t.toml", tabulated));
    EXPECT_NEAR(actuator::dead_band(resolve(table)->actuator, 1.0).linear, affine.linear, 2e-2 * affine.linear)
        << "the same friction; only C counts with the friction at 1 Nm instead of mu";
}

TEST_F(Simulate, WritesItsFilesAndLeavesOthersAlone) {
    const fs::path folder = folder_ / "out" / "pnrvsa";
    write("out/pnrvsa/k_se.stl", "a solid");
    const Simulation simulation = simulated(profile::read_profile(fixtures::shipped("pnrvsa")), {.levels = 4});
    const auto rows = report::write_simulation(simulation, folder);
    ASSERT_EQ(rows.size(), 3u);
    for (const FileRow& row : rows) EXPECT_EQ(core::sha256_hex(core::read_file(folder / row.entry.name)), row.entry.sha256);
    const auto first = fixtures::contents(folder);
    EXPECT_EQ(first.size(), 4u);
    EXPECT_EQ(first.at("k_se.stl"), "a solid");
    (void)report::write_simulation(simulated(profile::read_profile(fixtures::shipped("pnrvsa")), {.levels = 4}), folder);
    EXPECT_TRUE(fixtures::contents(folder) == first) << "equal input, equal bytes";
    const std::string& csv = first.at("dead_band.csv");
    EXPECT_TRUE(csv.starts_with("tau_Nm,linear_rad,extreme_rad,protocol_rad,condition_6,joint_stiffness_Nm_per_rad,capstan_rad\n"));
    const auto table = rows_of(csv);
    const auto json = nlohmann::json::parse(first.at("simulation.json"));
    ASSERT_EQ(table.size(), 4u);
    for (std::size_t i = 0; i < table.size(); ++i) {
        ASSERT_EQ(table[i].size(), 7u);
        EXPECT_EQ(table[i][1], simulation.levels[i].dead_band.linear) << "17 digits give every bit back";
        EXPECT_EQ(table[i][3], json["levels"][i]["measured_rad"].get<double>());
    }
}

TEST_F(Simulate, RelativesAreComparedAndNotMade) {
    const profile::Profile bidirectional = profile::read_profile(fs::path(FUSEE_SOURCE_DIR) / "profiles/relatives/bidirectional.toml");
    const Simulation simulation = simulated(bidirectional);
    EXPECT_EQ(simulation.survey.arrangement, actuator::Arrangement::kBidirectional);
    EXPECT_NEAR(simulation.levels.back().dead_band.linear, simulation.survey.dead_band.high, 1e-12);
    EXPECT_TRUE(std::isnan(simulation.levels.back().dead_band.exact_width));
    try {
        require_parts(bidirectional);
        FAIL();
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.field(), "rig.arrangement");
    }
    EXPECT_THROW(require_parts(profile::read_profile(fs::path(FUSEE_SOURCE_DIR) / "profiles/paper/new_springs.toml")), core::InvalidInput);
    EXPECT_NO_THROW(require_parts(profile::read_profile(fixtures::shipped("pnrvsa"))));
}

TEST_F(Simulate, ALawThatCannotBeIsRefusedWithItsLimit) {
    const auto refused = simulate(changed("pnrvsa", {{"law.start_torque_Nm", "0.2"}}));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.refusal().front().rule, "law.transmission");
}

// A formula's mistake is the caller's, and its key is named.
TEST_F(Simulate, AFormulasMistakeNamesItsKey) {
    std::string text = core::read_file(fs::path(FUSEE_SOURCE_DIR) / "profiles/paper/as_measured.toml");
    const std::string file = "dead_band_file = \"table_2_wanted.csv\"", csv = "measured = \"table_2.csv\"";
    text.replace(text.find(file), file.size(), "dead_band_deg = \"100 * exp(-\"");
    text.erase(text.find(csv), csv.size());
    try {
        (void)simulate(profile::read_profile(write("f.toml", text)));
        FAIL();
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.field(), "law.dead_band_deg");
    }
}

}  // namespace
}  // namespace fusee::pipeline
