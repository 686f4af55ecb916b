#include <cmath>
#include <optional>

#include "fusee/core/units.h"
#include "toolpath/fixture.h"

namespace fusee::toolpath {
namespace {

/// Every position of the moves in inverse time, with the feed word that leads there.
struct Stop {
    double a, x, y, z, feed;
};
std::vector<std::vector<Stop>> passes_of(const std::string& program) {
    std::vector<std::vector<Stop>> passes;
    bool inverse = false;
    Words here{{'Z', 0.0}};
    for (const Words& words : lines_of(program)) {
        if (const auto g = words.find('G'); g != words.end() && (g->second == 93 || g->second == 94)) {
            inverse = g->second == 93;
            if (inverse) passes.push_back({{here['A'], here['X'], here['Y'], here['Z'], 0.0}});
            continue;
        }
        for (const auto& [letter, value] : words) here[letter] = value;
        if (inverse) passes.back().push_back({here['A'], here['X'], here['Y'], here['Z'], here['F']});
    }
    return passes;
}

// h = 12 + 2 cos psi: at A = -psi the contact lies at Y = -h' = 2 sin psi and the tip at Z = h - 0.5.
TEST(Wrap, StandsOverTheContactOfAnEccentricDisc) {
    const auto passes = passes_of(wrap_program(disc(), {}, "test").text);
    ASSERT_EQ(passes.size(), 15u);  // lips 1.5 mm above the floor, 0.1 mm a pass
    for (std::size_t pass = 0; pass < passes.size(); ++pass)
        for (const Stop& stop : passes[pass]) {
            const double psi = -core::rad_from_deg(stop.a), left = 0.1 * static_cast<double>(passes.size() - 1 - pass);
            EXPECT_NEAR(stop.y, 2.0 * std::sin(psi), 2e-5);  // A and Y are printed to five places
            EXPECT_NEAR(stop.z, 11.5 + 2.0 * std::cos(psi) + left, 2e-5);
            EXPECT_EQ(stop.x, 0.0);
        }
    EXPECT_NEAR(std::abs(passes.back().back().a - passes.back().front().a), 360.0, 1e-4);
}

// On the round disc the tip runs along a circle: the time of a move is its length over the feed.
TEST(Wrap, InverseTimeKeepsTheFeedAlongThePart) {
    Settings settings;
    settings.wrap_feed = 150.0 / 60e3;
    const auto passes = passes_of(wrap_program(disc(0.0), settings, "test").text);
    const std::vector<Stop>& floor = passes.back();
    for (std::size_t i = 1; i < floor.size(); ++i) {
        const double turn = core::rad_from_deg(std::abs(floor[i].a - floor[i - 1].a)), way = 2.0 * 11.5 * std::sin(0.5 * turn);
        EXPECT_NEAR(floor[i].feed * way, 150.0, 0.1);  // A and F are rounded, the last step is short
    }
}

TEST(Wrap, TheOtherRotarySenseTurnsAOnly) {
    Settings other;
    other.rotary_sign = -1;
    const auto a = passes_of(wrap_program(disc(), {}, "test").text), b = passes_of(wrap_program(disc(), other, "test").text);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.back().size(); ++i) {
        EXPECT_EQ(a.back()[i].a, -b.back()[i].a);
        EXPECT_EQ(a.back()[i].y, b.back()[i].y);
        EXPECT_EQ(a.back()[i].z, b.back()[i].z);
    }
}

// A helix advances along X and is cut into round stock, layer by layer, where material remains.
TEST(Wrap, FollowsAHelixDownFromRoundStock) {
    const solid::Part part = helix();
    const auto passes = passes_of(wrap_program(part, {}, "test").text);
    double highest = 0.0, deepest = 1e9;
    for (const auto& pass : passes)
        for (const Stop& stop : pass) {
            const cam::PathPoint p = part.cam.path(-core::rad_from_deg(stop.a));
            EXPECT_NEAR(stop.x, 1e3 * p.z, 2e-5);
            EXPECT_NEAR(stop.y, -1e3 * p.slope, 2e-5);
            EXPECT_GE(stop.z, 1e3 * p.h - 0.5 - 2e-5);
            highest = std::max(highest, stop.z);
            deepest = std::min(deepest, stop.z - (1e3 * p.h - 0.5));
        }
    EXPECT_NEAR(deepest, 0.0, 2e-5);
    EXPECT_GT(highest, 12.0);  // the flange reaches beyond the largest arm
}

}  // namespace
}  // namespace fusee::toolpath
