#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "fixture.h"
#include "fusee/cam/cam.h"
#include "fusee/cam/certificate.h"

// Every guide with every path, for both parts, over half a turn to three and a half: made, convex, and with the law's arm by a solver that
// uses only the curve.
namespace fusee::cam {
namespace {

using namespace test;

struct Towards {
    const char* name;
    Guide guide;
};
constexpr double kUp = core::kPi / 2.0, kHigh = 8e-3;
const Towards kGuides[] = {{"parallel", {GuideKind::kParallel, kUp, 0.0, 0.0, 1, 0.0}},
                           {"point", {GuideKind::kPoint, kUp, 0.25, 0.0, 1, kHigh}},
                           {"idler_left", {GuideKind::kIdler, kUp, 0.25, 8e-3, 1, kHigh}},
                           {"idler_right", {GuideKind::kIdler, kUp, 0.25, 8e-3, -1, kHigh}}};
struct Along {
    const char* name;
    PathKind kind;
    Lead lead;
};
const Along kPaths[] = {{"planar", PathKind::kPlanar, Lead::kConstantPitch},
                        {"pitch", PathKind::kHelix, Lead::kConstantPitch},
                        {"aimed", PathKind::kHelix, Lead::kAimedAtGuide}};

struct SurveyedCam {
    Towards towards;
    Along along;
    PartKind part;
    double turns;
    int torque_sign;
};
std::string name_of(const SurveyedCam& c) {
    return std::string(to_string(c.part)) + "_" + c.towards.name + "_" + c.along.name + "_" +
           std::to_string(static_cast<int>(10 * c.turns)) + (c.torque_sign < 0 ? "_back" : "");
}
void PrintTo(const SurveyedCam& c, std::ostream* out) { *out << name_of(c); }

std::vector<SurveyedCam> all_cases() {
    std::vector<SurveyedCam> all;
    for (const Towards& towards : kGuides)
        for (const Along& along : kPaths)
            for (const PartKind part : {PartKind::kSeries, PartKind::kParallel})
                for (const double turns : {0.5, 0.9, 1.5, 2.5, 3.5}) {
                    if (along.kind == PathKind::kPlanar && turns > 0.9) continue;  // "cam.wrap": cam_test.cpp
                    if (along.lead == Lead::kAimedAtGuide && towards.guide.kind == GuideKind::kParallel) continue;  // nothing to aim at
                    all.push_back({towards, along, part, turns, static_cast<int>(all.size() % 2) * 2 - 1});
                }
    return all;
}

/// Springs that turn either cam by `turns`: F_SE = 0.05 + 0.02 x + 0.0004 x^2, F_PE = 0.05 + 0.01 x + 0.0002 x^2 [Nm]; arms about 10 mm.
ArmFunction arm_over(PartKind kind, double turns) {
    const double x = 2.0 * core::kPi * turns, capstan = 0.01;
    const auto law = spring::make_pair_law(spring::make_polynomial({0.05, 0.02, 0.0004}), spring::make_polynomial({0.05, 0.01, 0.0002}),
                                           0.1, 0.1 + 0.03 * x + 0.0006 * x * x)
                         .value();
    return kind == PartKind::kSeries ? ArmFunction(kind, law, torsion(0.022, 2.4), capstan)
                                     : ArmFunction(kind, law, compression(100.0, 0.05), capstan);
}

/// Arm of the taut cable in the plane: the largest moment of a line over the curve within a quarter turn of the contact, by trial.
double taut_arm(const Cam& cam, const Contact& contact) {
    const Guide& guide = cam.options.guide;
    const double back = -cam.rotation_sign * contact.arm.angle, sign = cam.options.torque_sign;
    const double gx = guide.distance * std::cos(guide.direction + back), gy = guide.distance * std::sin(guide.direction + back);
    double best = -std::numeric_limits<double>::infinity();
    constexpr int kTrials = 60;
    for (int i = -kTrials; i <= kTrials; ++i) {
        const PathPoint p = cam.path(contact.path.psi + 0.25 * i / kTrials);
        double along_x = std::cos(guide.direction + back), along_y = std::sin(guide.direction + back);
        if (guide.kind != GuideKind::kParallel) {
            const double vx = gx - p.x(), vy = gy - p.y(), length = std::hypot(vx, vy);
            const double s = guide.kind == GuideKind::kIdler ? guide.sense * guide.radius / length : 0.0, c = std::sqrt(1.0 - s * s);
            // The centre lies `radius` to the left of the cable where sense is 1.
            along_x = (c * vx + s * vy) / length, along_y = (c * vy - s * vx) / length;
        }
        best = std::max(best, sign * (p.x() * along_y - p.y() * along_x));
    }
    return best;
}

class Survey : public testing::TestWithParam<SurveyedCam> {};
INSTANTIATE_TEST_SUITE_P(Cam, Survey, testing::ValuesIn(all_cases()), [](const auto& one) { return name_of(one.param); });

TEST_P(Survey, IsMadeConvexAndHasItsArm) {
    const SurveyedCam& c = GetParam();
    CamOptions o;
    o.guide = c.towards.guide;
    o.torque_sign = c.torque_sign;
    o.path.kind = c.along.kind;
    o.path.lead = c.along.lead;
    o.path.pitch = 4e-3;
    const auto made = synthesize_cam(arm_over(c.part, c.turns), o);
    ASSERT_TRUE(made) << core::to_line(made.refusal().front());
    EXPECT_NEAR(made->working.back().arm.angle, 2.0 * core::kPi * c.turns, 0.5 * c.turns);
    for (std::size_t i = 3; i < made->working.size(); i += 98) {
        const Contact& row = made->working[i];
        // trials 4e-3 rad apart: rho (4e-3)^2/8, 2e-6 of an arm as long as rho
        EXPECT_NEAR(taut_arm(*made, row) * std::cos(row.fleet), row.arm.arm, 1e-5 * row.arm.arm) << i;
    }
    const Certificate proof = certify(*made);
    EXPECT_EQ(proof.convex, Proof::kProven) << proof.open;
    EXPECT_EQ(proof.ordered, Proof::kProven) << proof.open;
}

}  // namespace
}  // namespace fusee::cam
