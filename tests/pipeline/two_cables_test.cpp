#include <algorithm>
#include <cmath>
#include <vector>

#include "fusee/batch/batch.h"
#include "fusee/core/error.h"
#include "fusee/pipeline/budget.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/pipeline/springs.h"
#include "pipeline/fixture.h"
#include "second_reader.h"

// A law of both signs by two cables. The second reader recomputes its torque from the bytes of both STL files, the numbers of cam.json and
// cam_back.json, and the springs; it shares no code with the program.
namespace fusee::pipeline {
namespace {

constexpr double kLinkTorque = 0.5 * 9.80665 * 0.2;                      // m g l [Nm]
constexpr double kFromAngle = -M_PI / 6.0, kToAngle = 2.0 * M_PI / 3.0;  // -30 to 120 deg
constexpr double kOfLargest = 1e-3;                                      // of the largest torque

using second_reader::Point;

/// One spool: its torque over the angle of the law, with its sign [Nm].
class Spool {
public:
    Spool(const fs::path& folder, const std::string& name)
        : part_(nlohmann::json::parse(core::read_file(folder / (name + ".json")))),
          floor_(second_reader::floor_of(core::read_file(folder / (name + ".stl")))) {
        double drawn = part_["spring"]["preload_m"], before = 0.0;
        for (std::size_t i = 0; i <= kSteps; ++i) {
            const double arm = 1e-3 * second_reader::cable_arm(floor_, part_, step() * static_cast<double>(i));
            if (i > 0) drawn += 0.5 * step() * (arm + before);
            torques_.push_back(part_["spring"]["rate_N_per_m"].get<double>() * drawn * arm);
            before = arm;
        }
    }
    [[nodiscard]] double torque(double angle) const {
        const int sense = part_["shaft"]["sense"];
        const auto i = static_cast<std::size_t>(std::lround(sense * (angle - part_["shaft"]["first_rad"].get<double>()) / step()));
        return sense * torques_.at(i);
    }
    [[nodiscard]] const nlohmann::json& part() const { return part_; }
    [[nodiscard]] std::size_t corners() const { return floor_.size(); }
    static constexpr std::size_t kSteps = 600;
    static double step() { return (kToAngle - kFromAngle) / kSteps; }

private:
    nlohmann::json part_;
    std::vector<Point> floor_;
    std::vector<double> torques_;
};

class TwoCables : public fixtures::TempFolder {
protected:
    profile::Profile shipped(const fixtures::Changes& changes = {}) const {
        const std::string text =
            fixtures::with_key(core::read_file(fixtures::shipped("single/two_cables")), "outputs.formats", R"(["stl", "3mf"])");
        return profile::read_profile(write("two_cables.toml", fixtures::with_keys(text, changes)));
    }
};

TEST_F(TwoCables, FindsTheTorqueOfGravityInBothStlFiles) {
    const batch::MakeResult result = batch::make(shipped(), {.out = folder_ / "out"});
    for (const core::Finding& f : result.findings) EXPECT_FALSE(core::is_broken(f)) << core::to_line(f);
    ASSERT_TRUE(result.made);
    const Spool forth(result.folder, "cam"), back(result.folder, "cam_back");
    ASSERT_GT(forth.corners(), 200U);
    double worst = 0.0, least = 0.0;
    for (std::size_t i = 0; i <= Spool::kSteps; ++i) {
        const double angle = kFromAngle + Spool::step() * static_cast<double>(i), found = forth.torque(angle) + back.torque(angle);
        EXPECT_GT(forth.torque(angle), 0.29) << "a slack cable";
        EXPECT_LT(back.torque(angle), -0.29) << "a slack cable";
        worst = std::max(worst, std::abs(found - kLinkTorque * std::sin(angle)));
        least = std::min(least, found);
    }
    EXPECT_LT(worst, kOfLargest * kLinkTorque);
    EXPECT_NEAR(least, kLinkTorque * std::sin(kFromAngle), kOfLargest * kLinkTorque) << "it changes its sign within the range";
    RecordProperty("worst_relative", std::to_string(worst / kLinkTorque));
    const auto read =
        std::count_if(result.findings.begin(), result.findings.end(), [](const auto& f) { return f.rule == "readback.torque"; });
    EXPECT_GE(read, 1);
    for (const core::Finding& f : result.findings)
        EXPECT_TRUE(f.what.find("cam_back)") == std::string::npos || f.where.starts_with("cam_back")) << core::to_line(f);

    // On one key, as the files stand: at the first angle the guide of the way back is where that of the other cable is.
    const double turned = forth.part()["rotation_sign"].get<int>() * (kToAngle - kFromAngle);
    const nlohmann::json &a = forth.part()["guide"]["position_mm"], &b = back.part()["guide"]["position_mm"];
    const double x = b[0], y = b[1];
    EXPECT_NEAR(std::cos(turned) * x - std::sin(turned) * y, a[0].get<double>(), 1e-9);
    EXPECT_NEAR(std::sin(turned) * x + std::cos(turned) * y, a[1].get<double>(), 1e-9);
    EXPECT_EQ(back.part()["rotation_sign"].get<int>(), -forth.part()["rotation_sign"].get<int>());
    EXPECT_GT(back.part()["shaft"]["height_mm"].get<double>(), 5.0);
}

/// T = (T + hypot(T, 2 t))/2 + t less the same of -T: the difference is T, and each is above t.
TEST_F(TwoCables, BothCablesStayTautAndTheirDifferenceIsTheLaw) {
    const auto design = resolve(shipped({{"law.from_deg", "-90.0"}, {"law.to_deg", "90.0"}}));
    ASSERT_TRUE(design);
    ASSERT_EQ(design->ways.size(), 2U);
    const double travel = M_PI, least = 0.3;
    for (double x = 0.0; x <= travel; x += 0.01) {
        const double forth = design->ways[0].law()->at_angle(x).tau, back = design->ways[1].law()->at_angle(travel - x).tau;
        const double wanted = kLinkTorque * std::sin(x - M_PI / 2.0);
        EXPECT_NEAR(forth - back, wanted, 1e-10);
        EXPECT_NEAR(forth, least + 0.5 * (wanted + std::hypot(wanted, 2.0 * least)), 1e-10);
        EXPECT_GT(std::min(forth, back), least);
    }
    EXPECT_NEAR(design->ways[0].law()->at_angle(M_PI / 2.0).tau, 2.0 * least, 1e-10);
}

TEST_F(TwoCables, TheFilesCompensatedForAProcessSayWhereTheyStand) {
    const batch::MakeResult result = batch::make(shipped({{"compensation.shrink_x_percent", "0.4"}}), {.out = folder_ / "out"});
    ASSERT_TRUE(result.made);
    for (const std::string name : {"cam", "cam_back"}) {
        const auto nominal = nlohmann::json::parse(core::read_file(result.folder / (name + ".json")));
        EXPECT_EQ(nlohmann::json::parse(core::read_file(result.folder / (name + "_compensated.json")))["shaft"], nominal["shaft"]) << name;
    }
}

TEST_F(TwoCables, AFindingNamesThePartAndTheKeyOfItsWay) {
    const Evaluation seen = evaluate(shipped({{"cam.back.preload_mm", "200.0"}}), Depth::kOutline);
    ASSERT_EQ(seen.parts.size(), 2U);
    EXPECT_EQ(seen.parts[0].name, "cam");
    EXPECT_EQ(seen.parts[1].name, "cam_back");
    EXPECT_FALSE(core::any_error(seen.parts[0].findings));
    EXPECT_TRUE(core::any_error(seen.parts[1].findings));
    for (const core::Finding& f : seen.parts[1].findings) {
        const std::string line = core::to_line(f);
        EXPECT_TRUE(!f.where.starts_with("cam") || f.where.starts_with("cam_back")) << line;
        EXPECT_EQ(line.find("k_pe"), std::string::npos) << line;
        for (const core::Changes& changes : f.suggestion.changes())
            for (const core::Change& change : changes) EXPECT_NE(change.key, "cam.spring.preload_mm") << line;
    }
}

/// A rate that is 5 % off (one standard deviation) changes the torque of each cable by 5 %, independently.
TEST_F(TwoCables, TheirErrorsAddAsIndependentOnes) {
    const auto budget = find_budget(shipped(), 0);
    ASSERT_TRUE(budget);
    ASSERT_EQ(budget->parts.size(), 1U);
    const auto design = resolve(shipped());
    for (const design::budget::TorqueError& place : budget->parts.front().places) {
        const double forth = design->ways[0].law()->at_angle(place.travel).tau,
                     back = design->ways[1].law()->at_angle(kToAngle - kFromAngle - place.travel).tau;
        EXPECT_NEAR(place.torque, forth - back, 0.01 * kLinkTorque);
        EXPECT_NEAR(place.sigma[static_cast<std::size_t>(design::budget::Source::kRate)], 0.05 * std::hypot(forth, back) / kLinkTorque,
                    5e-3);
    }
}

TEST_F(TwoCables, WhatCannotDoBothSaysSo) {
    EXPECT_THROW(
        (void)evaluate(shipped({{"cam.hub.kind", "\"overhung\""}, {"cam.hub.boss_mm", "20.0"}, {"cam.hub.boss_height_mm", "10.0"}}),
                       Depth::kOutline),
        core::InvalidInput);
    const auto design = resolve(shipped());
    ASSERT_TRUE(design);
    EXPECT_THROW((void)find_springs(cam::PartKind::kParallel, *design, {}), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::pipeline
