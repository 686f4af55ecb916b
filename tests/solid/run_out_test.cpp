// Where a helix's groove ends, its lips run out into the flange: far enough, or not at all.
#include <gtest/gtest.h>

#include <cmath>

#include "fixture.h"
#include "fusee/core/error.h"
#include "fusee/solid/sweep.h"
#include "fusee/solid/validity.h"

namespace fusee::solid {
namespace {

using namespace test;

constexpr double kTurn = 2.0 * core::kPi;

/// Radius over h of a circle that is tangent where h'/h is that and holds the axis; and what lips on it need for their way out: where they
/// begin, h' R/(h rho) with R the circle's farthest point.
double circle_of(double steepness) { return 0.6 * (1.0 + steepness * steepness); }
double needed(double steepness) {
    const double r = circle_of(steepness);
    return steepness * (r + std::hypot(1.0 - r, steepness)) / r;
}

/// 1.2 turns of groove about a circle of 8 mm. From `kFlare` before its end on h'/h rises evenly to `steepness`, up to the groove's end
/// with a margin of 0.35 rad; beyond, the contour is such a circle, as a run-out lays it. [m]
cam::Cam flaring(double steepness) {
    constexpr double kRadius = 8e-3, kFlare = 1.2, kPitch = 6e-3, kMargin = 0.35;
    cam::Cam cam = snail(1.2, kPitch, 0.0, kRadius);
    cam.options.path.margin = kMargin;
    cam.groove_psi = {-1.6 * kMargin, 1.2 * kTurn + 1.6 * kMargin};
    const double end = cam.groove_psi.high, rate = steepness / kFlare;
    cam.path = [=](double psi) {
        const double x = std::clamp(psi - end + kFlare, 0.0, kFlare), h = kRadius * std::exp(0.5 * rate * x * x), slope = rate * x * h;
        const double rho = x > 0.0 ? h + rate * h + rate * x * slope : h, z = kPitch / kTurn * psi, on = psi - end;
        if (on <= 0.0) return cam::PathPoint{psi, h, slope, rho, z};
        const double r = circle_of(steepness) * h, off = h - r;
        return cam::PathPoint{psi, r + off * std::cos(on) + slope * std::sin(on), slope * std::cos(on) - off * std::sin(on), r, z};
    };
    return cam;
}

/// Width of the run-out beyond the groove's high end [rad].
double laid(const cam::Cam& cam, const PartOptions& options) {
    const auto section = groove_section(options.groove, cam.options.cable_diameter, options.chordal_error);
    return ColumnMaker(cam, section, flanges_of(options)).reach().high - cam.groove_psi.high;
}

// Known: the need of the lips, without their own height. Beyond 2 rad, once the longest run-out, the solids of the latter two met
// themselves.
TEST(RunOut, IsAsLongAsItsLipsNeed) {
    const PartOptions options = plain();
    for (const double steepness : {0.3, 1.25, 1.5}) {
        const cam::Cam cam = flaring(steepness);
        EXPECT_GT(laid(cam, options), 0.9 * needed(steepness)) << steepness;
        EXPECT_LE(laid(cam, options), kLongestRunOut) << steepness;
        const auto part = build_part(cam, options);
        ASSERT_TRUE(part) << steepness << ' ' << core::to_line(part.refusal().front());
        EXPECT_TRUE(validate(part->mesh).good()) << steepness;
    }
}

// Refusal: 7.9 rad are more than the longest; what it suggests is accepted.
TEST(RunOut, OfAnArmThatGrowsTooFastIsRefusedWithAMarginThatWouldDo) {
    cam::Cam cam = flaring(4.0);
    const auto part = outline_part(cam, plain());
    ASSERT_FALSE(part);
    ASSERT_EQ(part.refusal().size(), 1u);
    const core::Finding& f = part.refusal().front();
    EXPECT_EQ(f.rule, "solid.run_out");
    EXPECT_EQ(f.unit, "deg");
    EXPECT_GT(f.measured, f.allowed);
    EXPECT_NEAR(f.allowed, core::deg_from_rad(kLongestRunOut), 1e-9);
    EXPECT_NE(f.where.find("psi"), std::string::npos) << f.where;
    const std::string key = "k_pe.path.margin_deg = ";
    ASSERT_EQ(f.suggestion.text().rfind(key, 0), 0u) << f.suggestion.text();
    const double margin = core::rad_from_deg(std::stod(f.suggestion.text().substr(key.size())));
    cam.groove_psi = {cam.working_psi.low - 1.6 * margin, cam.working_psi.high + 1.6 * margin};
    EXPECT_TRUE(outline_part(cam, plain()));
}

// Where the working arc itself grows too fast, the law has to begin later: at the load of the first row that is flat enough.
TEST(RunOut, OfAWorkingArcThatGrowsTooFastAsksForAShorterLaw) {
    cam::Cam cam = flaring(4.0);
    cam.working_psi.high = cam.groove_psi.high;  // the arc itself is too steep, so that no margin helps
    for (int i = 0; i <= 100; ++i) {
        cam::Contact row;
        row.path = cam.path(cam.working_psi.high - 2.0 * i / 100);
        row.arm.tau = 0.5 + 0.005 * i, row.arm.state = 0.010 + 1e-5 * i;
        cam.working.push_back(row);
    }
    const auto part = outline_part(cam, plain());
    ASSERT_FALSE(part);
    const std::string& suggestion = part.refusal().front().suggestion.text();
    const std::string key = "law.start_torque_Nm = ";
    ASSERT_NE(suggestion.find(key), std::string::npos) << suggestion;
    const double load = std::stod(suggestion.substr(suggestion.find(key) + key.size()));
    EXPECT_GT(load, 0.5);
    EXPECT_LT(load, 1.0);
    EXPECT_NE(suggestion.find("k_pe.spring.preload_mm = "), std::string::npos);
}

// Law: where no other turn stands beside the run-out, nothing folds, however fast the arm grows.
TEST(RunOut, BesideNothingIsFree) {
    cam::Cam cam = flaring(4.0);
    cam.working_psi.low = cam.groove_psi.low = cam.groove_psi.high - 1.0;
    EXPECT_TRUE(outline_part(cam, plain()));
}

}  // namespace
}  // namespace fusee::solid
