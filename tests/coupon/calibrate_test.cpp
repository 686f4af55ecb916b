#include <gtest/gtest.h>

#include <map>

#include "coupon/fixture.h"
#include "refused.h"

namespace fusee::coupon {
namespace {

using test::without;
using test::World;

double value(const Calibration& found, const std::string& id) {
    const Figure* figure = found.find(id);
    return figure ? figure->value : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> unknown_of(const Calibration& found) {
    std::vector<std::string> ids;
    for (const Unknown& u : found.unknown) ids.push_back(u.id);
    return ids;
}

/// Without noise every result is exact to rounding.
TEST(Calibrate, RecoversWhatWasPlanted) {
    const World world;
    for (const Sheet& sheet : {world.sheet(), World::by_torque(world.sheet(), world)}) {
        const Calibration found = calibrate(sheet, {}, "c.csv");
        EXPECT_NEAR(value(found, "shrink_x"), world.shrink_x, 1e-12);
        EXPECT_NEAR(value(found, "shrink_y"), world.shrink_y, 1e-12);
        EXPECT_NEAR(value(found, "shrink_z"), world.shrink_z, 1e-12);
        EXPECT_NEAR(value(found, "contour_x"), 1e-3 * world.contour_mm, 1e-13);
        EXPECT_NEAR(value(found, "bore_offset"), 1e-3 * world.bore_offset_mm, 1e-12);
        EXPECT_NEAR(value(found, "disc_radius"), 1e-3 * world.radius_mm(), 1e-12);
        EXPECT_NEAR(value(found, "cable_axis"), 1e-3 * world.cable_axis_mm, 1e-12);
        EXPECT_NEAR(value(found, "series_rate"), world.series_rate, 1e-10);
        EXPECT_NEAR(value(found, "parallel_rate"), world.parallel_rate, 1e-6);
        EXPECT_EQ(unknown_of(found), std::vector<std::string>{"groove_ratio"});
    }
}

/// Of 400 noisy sheets each interval holds the truth in 95 %: 380 +- 4.4 by chance, so that 362 is four deviations off. Intervals of sums
/// of unequal freedom and those widened by the gauge hold it more often.
TEST(Calibrate, IntervalsHoldTheTruthAsOftenAsTheySay) {
    constexpr int kSheets = 400, kLeast = 362;
    const World world;
    const std::map<std::string, double> truth{{"shrink_x", world.shrink_x},
                                              {"shrink_y", world.shrink_y},
                                              {"contour_y", 1e-3 * world.contour_mm},
                                              {"bore_offset", 1e-3 * world.bore_offset_mm},
                                              {"disc_radius", 1e-3 * world.radius_mm()},
                                              {"cable_axis", 1e-3 * world.cable_axis_mm},
                                              {"series_rate", world.series_rate},
                                              {"parallel_rate", world.parallel_rate}};
    std::map<std::string, int> held;
    std::mt19937_64 random(7);
    for (int i = 0; i < kSheets; ++i) {
        const Calibration found =
            calibrate(world.sheet([&](double scatter) { return std::normal_distribution<double>(0.0, scatter)(random); }), {}, "c.csv");
        for (const auto& [id, exact] : truth) held[id] += found.find(id)->range.holds(exact) ? 1 : 0;
    }
    for (const auto& [id, exact] : truth) EXPECT_GE(held[id], kLeast) << id;
    for (const char* id : {"shrink_x", "disc_radius", "parallel_rate"}) EXPECT_LE(held[id], 397) << id << ": four deviations the other way";
}

TEST(Calibrate, AFigureStaysUnlessTheRowsContradictIt) {
    const World world;
    const Calibration found = calibrate(world.sheet(), {{kShrinkKeys[0], 0.00405}, {kSeriesRateKey, 0.03}}, "c.csv");
    EXPECT_FALSE(found.find("shrink_x")->changes()) << "0.405 % lies within what a caliper's digit leaves open";
    EXPECT_EQ(found.find("shrink_x")->used(), 0.00405);
    EXPECT_TRUE(found.find("shrink_y")->changes()) << "a compensation that no profile states is 0";
    EXPECT_TRUE(found.find("series_rate")->changes());
    EXPECT_FALSE(found.find("contour_x")->changes()) << "no key has it";
    // What follows from the shrinkage follows from the one that the files are going to have: (0.405 + 0.6)/2 % of 6.2 and of 15 mm.
    EXPECT_NEAR(value(found, "bore_offset"), 1e-3 * (world.bore_offset_mm - 0.000025 * 6.2), 1e-9);
    EXPECT_NEAR(value(found, "cable_axis"), 1e-3 * (world.cable_axis_mm + 0.000025 * 15.0), 1e-9);
}

TEST(Calibrate, SaysWhatTheRowsLeaveUnknown) {
    const Sheet full = World{}.sheet();
    EXPECT_EQ(unknown_of(calibrate(without(full, Item::kLengthX), {}, "c.csv")),
              (std::vector<std::string>{"shrink_x", "groove_ratio", "cable_axis"}));
    EXPECT_EQ(unknown_of(calibrate(without(full, Item::kDiscPull), {}, "c.csv")),
              (std::vector<std::string>{"groove_ratio", "disc_radius", "cable_axis", "series_rate"}));
    Sheet drawn_missing = full;
    drawn_missing.disc_floor_mm = 0.0;
    EXPECT_EQ(unknown_of(calibrate(drawn_missing, {}, "c.csv")), (std::vector<std::string>{"groove_ratio", "cable_axis"}));
    Sheet one_length = without(full, Item::kLengthZ);
    for (int i = 0; i < 3; ++i) one_length.rows.push_back({Item::kLengthZ, 25.0, 25.1});
    EXPECT_EQ(calibrate(one_length, {}, "c.csv").find("shrink_z"), nullptr)
        << "shrinkage and contour of one length cannot be distinguished";
    const Calibration bores = calibrate(Sheet{0.8, 15.0, full.of(Item::kBore)}, {}, "c.csv");
    ASSERT_NE(bores.find("bore_offset"), nullptr);
    EXPECT_NEAR(value(bores, "bore_offset"), 1e-3 * (0.12 + 0.005 * 6.2), 1e-9)
        << "it includes the holes' shrinkage, and a remark states this";
    EXPECT_EQ(bores.remarks.size(), 1u);
}

Sheet answers(Item item, const std::vector<std::pair<double, double>>& rows) {
    Sheet sheet;
    for (const auto& [given, yes] : rows) sheet.rows.push_back({item, given, yes});
    return sheet;
}

TEST(Calibrate, LaddersAreReadBetweenTheirRungs) {
    Sheet shaft = answers(Item::kShaftEnters, {{6.0, 0}, {6.1, 0}, {6.2, 1}, {6.3, 1}});
    shaft.rows.push_back({Item::kShaft, 6.0, 5.98});
    const Calibration found = calibrate(shaft, {}, "c.csv");
    ASSERT_NE(found.find("bore_offset"), nullptr);
    EXPECT_NEAR(found.find("bore_offset")->range.low, 0.12e-3, 1e-12);
    EXPECT_NEAR(found.find("bore_offset")->range.high, 0.22e-3, 1e-12);
    EXPECT_NEAR(value(found, "bore_offset"), 0.17e-3, 1e-12);

    const Calibration groove =
        calibrate(answers(Item::kCableSeats, {{0.5, 0}, {0.53, 0}, {0.56, 1}, {0.6, 1}}), {{kGrooveRatioKey, 0.53}}, "c.csv");
    EXPECT_EQ(value(groove, "groove_ratio"), 0.56);
    EXPECT_TRUE(groove.find("groove_ratio")->changes());
    const Calibration wide = calibrate(answers(Item::kCableSeats, {{0.5, 0}, {0.53, 1}, {0.6, 1}}), {{kGrooveRatioKey, 0.6}}, "c.csv");
    EXPECT_FALSE(wide.find("groove_ratio")->changes()) << "the cable seats in the profile's own groove";
    EXPECT_EQ(calibrate(answers(Item::kCableSeats, {{0.5, 0}, {0.7, 0}}), {}, "c.csv").find("groove_ratio"), nullptr);
}

TEST(Calibrate, RefusesWhatCannotBe) {
    EXPECT_EQ(field_refused([] {
                  return calibrate(answers(Item::kShaftEnters, {{6.1, 1}, {6.2, 0}}), {}, "c.csv");
              }),
              "c.csv: shaft_enters");
    EXPECT_EQ(field_refused([] { return calibrate(answers(Item::kCableSeats, {{0.5, 1}, {0.5, 0}}), {}, "c.csv"); }), "c.csv: cable_seats");
    World inches;
    inches.shrink_x = 1.0 - 1.0 / 25.4;
    EXPECT_EQ(field_refused([&] { return calibrate(inches.sheet(), {}, "c.csv"); }), "c.csv: length_x");
    World pushing;
    pushing.parallel_rate = -7000.0;
    EXPECT_EQ(field_refused([&] { return calibrate(pushing.sheet(), {}, "c.csv"); }), "c.csv: parallel_spring");
}

}  // namespace
}  // namespace fusee::coupon
