#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "fusee/core/error.h"
#include "fusee/plant/case_files.h"

namespace fusee::plant {
namespace {

/// The measured columns of each experiment by side and direction, at a few of its set points.
std::map<std::string, std::vector<double>> readings(const TestRig& test_rig, std::uint64_t stream) {
    const double scale = range_of(test_rig.nominal).scale;
    SetPoints points = set_points(false, scale);
    points.dead_band = {0.6 * scale};
    points.joint_stiffness = {0.8 * scale};
    Random noise(8, stream, 77);
    const Measured m = measure(test_rig, points, noise);
    const auto side = [](std::size_t i) { return i == 0 ? " agonist" : " antagonist"; };
    std::map<std::string, std::vector<double>> all;
    for (const BreakAwayRow& r : m.breakaway) all[std::string("breakaway") + side(r.side) + (r.backdrive ? " back" : "")].push_back(r.load);
    for (std::size_t i = 0; i < m.spring_pull.size(); ++i) {
        const PullRow& r = m.spring_pull[i];
        const std::string name = std::string(r.series ? "se" : "pe") + side(r.side);
        all[name].push_back(r.torque);
        // 61 rows up and 60 down a spring, the last one up at the top: row k down is at the deflection of row 60 - k up.
        if (!r.load) all[name + " loop"].push_back(m.spring_pull[i - 2 * (i % 121 - 60)].torque - r.torque);
    }
    for (const DeadBandRow& r : m.dead_band) {
        all["dead_band width"].push_back(r.q_high - r.q_low);
        all["dead_band middle"].push_back(0.5 * (r.q_high + r.q_low));
    }
    for (const StiffnessRow& r : m.joint_stiffness) all["joint_stiffness " + r.phase].push_back(r.q);
    for (const CocontractionRow& r : m.cocontraction) {
        if (r.motor == 0.0 && r.up) all["joint at rest"].push_back(r.q);
        for (std::size_t i : {0U, 1U}) all[std::string("cocontraction") + side(i) + (r.up ? " up" : " down")].push_back(r.theta[i]);
    }
    for (const LogRow& r : m.log) {
        all[r.time < 6.5 ? "log swing" : "log knock"].push_back(r.q);
        for (std::size_t i : {0U, 1U}) all[std::string("log") + side(i)].push_back(r.theta[i]);
    }
    return all;
}

double away(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

/// What tolerances and sensors make between two rigs of one drawing, root mean square of three pairs.
std::map<std::string, double> usual(const TestRig& test_rig) {
    const auto base = readings(test_rig, 0);
    std::map<std::string, double> spread;
    for (std::uint64_t i = 1; i <= 3; ++i) {
        TestRig other = test_rig;
        Random made(31, i, 5);
        other.truth = build(test_rig.nominal, test_rig.tolerance, made);
        for (const auto& [name, column] : readings(other, i)) spread[name] += std::pow(away(column, base.at(name)), 2) / 3.0;
    }
    for (auto& [name, variance] : spread) variance = std::sqrt(variance);
    return spread;
}

// Every effect moves at least one experiment by more than three times what two faultless rigs differ by.
TEST(Effects, EachStandsOutSomewhere) {
    const TestRig test_rig = draw_test_rig(40, 3);
    const auto base = readings(test_rig, 0);
    const auto spread = usual(test_rig);
    std::vector<std::string> ids = library_ids();
    for (const auto* more : {&outside_ids(), &form_blind_ids()}) ids.insert(ids.end(), more->begin(), more->end());
    std::uint64_t index = 0;
    for (const std::string& id : ids) {
        Random random(8, ++index, 1);
        const Effect effect = draw_effect(id, test_rig.nominal, random);
        TestRig faulty = test_rig;
        apply(effect, faulty.truth);
        double most = 0.0;
        std::string where;
        for (const auto& [name, column] : readings(faulty, 0)) {
            const double ratio = away(column, base.at(name)) / spread.at(name);
            if (ratio > most) most = ratio, where = name;
        }
        RecordProperty(id, std::to_string(most) + " in " + where);
        EXPECT_GT(most, 3.0) << id << ' ' << effect.side << ' ' << effect.size << ": most in " << where;
    }
}

TEST(Effects, CoverTheFormatAndMoreThanEightOutside) {
    EXPECT_EQ(library_ids().size(), 21U);
    EXPECT_GE(outside_ids().size(), 8U);
    EXPECT_GE(form_blind_ids().size(), 8U);
    std::set<std::string> all(library_ids().begin(), library_ids().end());
    for (const auto* more : {&outside_ids(), &form_blind_ids()}) {
        all.insert(more->begin(), more->end());
        for (const std::string& id : *more) EXPECT_EQ(id.rfind("outside.", 0), 0U) << id;
    }
    EXPECT_EQ(all.size(), library_ids().size() + outside_ids().size() + form_blind_ids().size());
}

// Wrong by a usual amount, which need not stand out: the experiments that the figure enters differ, those that it does not are the same.
TEST(Effects, AWrongFigureMovesWhatItEnters) {
    const TestRig test_rig = draw_test_rig(40, 3);
    const auto base = readings(test_rig, 0);
    std::uint64_t index = 0;
    for (const std::string& id : figure_ids()) {
        EXPECT_EQ(id.rfind("figure.", 0), 0U) << id;
        Random random(8, ++index, 1);
        TestRig faulty = test_rig;
        apply(draw_effect(id, test_rig.nominal, random), faulty.truth);
        std::set<std::string> moved;
        for (const auto& [name, column] : readings(faulty, 0))
            if (away(column, base.at(name)) > 0.0) moved.insert(name.substr(0, name.find(' ')));
        EXPECT_TRUE(moved.contains("log")) << id;
        for (const char* bench : {"breakaway", "se", "pe"}) EXPECT_FALSE(moved.contains(bench)) << id << ' ' << bench;
    }
}

TEST(Effects, SidesAreThoseOfTheirKind) {
    const Nominal nominal = draw_test_rig(40, 4).nominal;
    std::map<std::string, std::set<std::string>> sides;
    for (const std::string& id : library_ids())
        for (std::uint64_t i = 0; i < 30; ++i) {
            Random random(9, i, 1);
            sides[id].insert(draw_effect(id, nominal, random).side);
        }
    const std::set<std::string> any{"agonist", "antagonist", "both"}, none{"none"};
    EXPECT_EQ(sides["gear.coulomb"], any);
    EXPECT_EQ(sides["cable.stretch"], any);
    EXPECT_EQ(sides["sensor.torque_scale"], any);
    EXPECT_EQ(sides["pe.bottoming"], any);
    for (const char* id : {"joint.stop", "cable.tension_friction", "sensor.joint_offset"}) EXPECT_EQ(sides[id], none) << id;
}

TEST(Effects, OneSidedOnesLeaveTheOtherSideAlone) {
    TestRig test_rig = draw_test_rig(40, 5);
    const SideTruth before = test_rig.truth.sides[0];
    apply({"gear.coulomb", "antagonist", 0.05, {}}, test_rig.truth);
    EXPECT_EQ(test_rig.truth.sides[0].coulomb, before.coulomb);
    EXPECT_EQ(test_rig.truth.sides[1].coulomb, 0.05);
}

TEST(Effects, RefusesWhatItDoesNotKnow) {
    TestRig test_rig = draw_test_rig(40, 6);
    EXPECT_THROW(apply({"gear.magic", "both", 0.1, {}}, test_rig.truth), core::InvalidInput);
    EXPECT_THROW(apply({"gear.coulomb", "none", 0.1, {}}, test_rig.truth), core::InvalidInput);
    EXPECT_THROW(apply({"joint.stop", "both", 0.1, {}}, test_rig.truth), core::InvalidInput);
    EXPECT_THROW(apply({"gear.stribeck", "both", 0.5, {}}, test_rig.truth), core::InvalidInput);  // without its speed
    Random random(1, 1, 1);
    EXPECT_THROW(static_cast<void>(draw_effect("gear.magic", test_rig.nominal, random)), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::plant
