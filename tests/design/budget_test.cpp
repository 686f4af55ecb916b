#include "fusee/design/budget.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/error.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"
#include "part_model.h"
#include "pipeline/fixture.h"

namespace fusee::design::budget {
namespace {

/// A shipped joint with these tolerances on both parts.
struct Joint {
    pipeline::ResolvedDesign design;
    std::array<cam::Cam, 2> cams;

    explicit Joint(const std::string& name)
        : design(pipeline::resolve(profile::read_profile(fixtures::shipped(name))).value()),
          cams{pipeline::design_cam(cam::PartKind::kSeries, design).value(),
               pipeline::design_cam(cam::PartKind::kParallel, design).value()} {}

    [[nodiscard]] Subject subject(const Tolerances& tolerances) const {
        const auto part = [&](std::size_t i) {
            const profile::PartSpec& spec = design.spec(cams[i].kind);
            return PartSubject{&cams[i], pipeline::pulled_spring(spec), spec.allowance, tolerances};
        };
        return {design.actuator, {part(0), part(1)}};
    }
};

const Joint& pnrvsa() {
    static const Joint joint("pnrvsa");
    return joint;
}

Tolerances none() {
    return {.contour = 0, .runout = 0, .guide = 0, .direction = 0, .rate = 0, .preload = 0, .cable = 0, .zero = 0, .friction = 0};
}

Tolerances scaled(double share) {
    const Tolerances t;
    return {t.contour * share, t.runout * share, t.guide * share, t.direction * share, t.rate * share,
            t.preload * share, t.cable * share,  t.zero * share,  t.friction * share};
}

/// One error of each kind, `size` times a usual one.
std::vector<PartErrors> each_error(double size) {
    return {{.contour = 1e-4 * size}, {.cable = 1e-4 * size}, {.runout = {1e-4 * size, 0.0}}, {.runout = {0.0, 1e-4 * size}},
            {.guide = 1e-3 * size},   {.rate = 0.05 * size},  {.preload = 0.02 * size},       {.zero = 0.01 * size}};
}

// A disc of 20 mm, its law's arm constant: an axis that is off by e changes the arm by e . n, a thicker cable by its radius, and a guide
// has no influence, since h' = 0 (eq. 1).
TEST(PartModel, DiscHasTheKnownArms) {
    cam::Cam disc = pnrvsa().cams[1];
    disc.path = [](double psi) { return cam::PathPoint{psi, 0.02, 0.0, 0.02, 0.0}; };
    for (cam::Contact& c : disc.working) c.path = disc.path(c.path.psi), c.arm.arm = 0.02, c.arm.slope = 0.0;
    disc.options.guide.distance = 10.0;
    for (cam::Contact& c : disc.working)  // the normal at which the tangent goes through the guide: cos(psi - direction) D = h
        c.path.psi = disc.options.guide.direction - disc.rotation_sign * c.arm.angle - disc.options.torque_sign * std::acos(0.02 / 10.0);
    const PartSubject subject{&disc, pnrvsa().subject({}).parts[1].spring, {}, {}};
    const PartModel model(subject, 0.03);
    const std::vector<double> drawn = model.arms({}), shifted = model.arms({.runout = {3e-4, -2e-4}}), thick = model.arms({.cable = 1e-4}),
                              guided = model.arms({.guide = 5e-3});
    const std::size_t rows = drawn.size(), last = disc.working.size() - 1;
    for (std::size_t i = 0; i < rows; ++i) {
        const double psi = disc.working[i * last / (rows - 1)].path.psi;
        EXPECT_NEAR(drawn[i], 0.02, 1e-12);
        EXPECT_NEAR(shifted[i] - 0.02, 3e-4 * std::cos(psi) - 2e-4 * std::sin(psi), 2e-8) << "e t dpsi, dpsi = e/D";
        EXPECT_NEAR(thick[i] - 0.02, 1e-4, 1e-12);
        EXPECT_NEAR(guided[i] - 0.02, 0.0, 1e-12);
    }
}

/// The follower's lift at a cam angle on the curve of roller centres that is moved outwards by `contour` and shifted by `runout`, its line
/// by `aside`: where the turned curve meets the line, between neighbouring points [m].
double lift_on(const cam::Cam& cam, double angle, double contour, const Eigen::Vector2d& runout, double aside) {
    const cam::Roller& roller = cam.options.roller;
    const Eigen::Vector2d along(std::cos(roller.direction), std::sin(roller.direction)), across(along.y(), -along.x());
    const auto turned = [&](double turn, const Eigen::Vector2d& v) { return Eigen::Vector2d(Eigen::Rotation2Dd(turn) * v); };
    std::vector<Eigen::Vector2d> seen;  // (along, across) of each point of the curve
    for (const cam::Contact& c : cam.working) {
        const Eigen::Vector2d n(std::cos(c.path.psi), std::sin(c.path.psi)), t(-n.y(), n.x());
        const Eigen::Vector2d centre = (c.path.h + roller.radius + contour) * n + c.path.slope * t + runout;
        const Eigen::Vector2d world = turned(cam.rotation_sign * angle, centre);
        seen.emplace_back(world.dot(along), world.dot(across));
    }
    const cam::Contact& first = cam.working.front();  // where the line is, whatever the sign of its offset
    const Eigen::Vector2d n(std::cos(first.path.psi), std::sin(first.path.psi)), t(-n.y(), n.x());
    const double line = ((first.path.h + roller.radius) * n + first.path.slope * t).dot(across) + aside;
    for (std::size_t i = 1; i < seen.size(); ++i) {
        const double a = seen[i - 1].y() - line, b = seen[i].y() - line;
        if (a * b <= 0.0 && seen[i].x() > 0.0) return seen[i - 1].x() + (seen[i].x() - seen[i - 1].x()) * a / (a - b);
    }
    return core::kNan;
}

// A roller's torque is k s ds/dangle; what an error does to s is measured on the moved curve.
TEST(PartModel, RollerHasTheTorquesOfItsMovedCurve) {
    const auto design = pipeline::resolve(profile::read_profile(fixtures::shipped("single/hardening"))).value();
    const cam::Cam cam = pipeline::design_cam(cam::PartKind::kParallel, design).value();
    const spring::BaseSpring& s = design.profile.k_pe.spring;
    const PartSubject subject{&cam, s, {}, {}};
    const PartModel model(subject, 1.0);
    double largest = 0.0;
    for (const std::size_t row : model.places()) largest = std::max(largest, std::abs(model.torque(row)));
    const auto torque = [&](double angle, const PartErrors& e) {
        const auto lift = [&](double at) { return lift_on(cam, at, e.contour, e.runout, e.guide); };
        constexpr double kStep = 0.02;
        const double moved = lift(angle) - lift(cam.working[3].arm.angle) + cam.working[3].arm.travel;
        return s.rate * (s.preload + moved) * (lift(angle + kStep) - lift(angle - kStep)) / (2.0 * kStep);
    };
    for (const PartErrors& e : {PartErrors{.contour = 1e-4}, {.runout = {1e-4, 0.0}}, {.runout = {0.0, 1e-4}}, {.guide = 3e-4}})
        for (const std::size_t row : model.places()) {
            if (row < 4 || row > 44) continue;  // the moved curve ends here
            const double found = torque(model.travel(row), e) - torque(model.travel(row), {});
            SCOPED_TRACE(testing::Message() << "row " << row);
            EXPECT_NEAR(std::abs(found), std::abs(model.change(row, e)), 1e-3 * largest);
        }
    EXPECT_NEAR(model.change(20, {.rate = 0.05}), 0.05 * model.torque(20), 1e-12);
}

// Halving an error quarters what the first order leaves out.
TEST(PartModel, FirstOrderIsTheLimitOfTheExactTorque) {
    for (const char* name : {"pnrvsa", "first_prototype", "measured_table"}) {
        const Joint joint(name);
        const Subject subject = joint.subject({});
        for (const PartSubject& part : subject.parts) {
            const PartModel model(part, subject.actuator.capstan_radius);
            const auto errors = each_error(0.1), halves = each_error(0.05);
            for (std::size_t e = 0; e < errors.size(); ++e)
                for (const std::size_t row : model.places()) {
                    if (row == 0 || row + 1 >= 48) continue;  // the interpolants end here
                    const auto rest = [&](const PartErrors& error) {
                        const double x = model.travel(row);
                        const double drawn = model.spring({})->force(x);
                        return model.spring(error)->force(x + error.zero) / drawn - 1.0 - model.linear(row, error);
                    };
                    const double size = std::abs(model.linear(row, errors[e]));
                    SCOPED_TRACE(testing::Message() << name << ' ' << to_string(part.cam->kind) << " error " << e << " row " << row);
                    EXPECT_LE(std::abs(rest(errors[e])), 0.05 * size + 2e-5);
                    EXPECT_LE(std::abs(rest(halves[e])), 0.3 * std::abs(rest(errors[e])) + 2e-5);
                }
        }
    }
}

TEST(Budget, WithoutTolerancesThereIsNone) {
    const double torques[] = {1.0};
    const Budget budget = budget_of(pnrvsa().subject(none()), torques, {.draws = 20});
    for (const PartBudget& part : budget.parts)
        for (const TorqueError& place : part.places) {
            EXPECT_EQ(place.whole(), 0.0);
            EXPECT_NEAR(place.sampled.low, 0.0, 1e-12);
            EXPECT_NEAR(place.sampled.high, 0.0, 1e-12);
        }
    EXPECT_EQ(budget.widths.front().whole, 0.0);
    EXPECT_NEAR(budget.widths.front().sampled.width(), 0.0, 1e-9);
    const double drawn = actuator::dead_band(pnrvsa().design.actuator, 1.0).exact_width;
    EXPECT_NEAR(budget.widths.front().nominal / drawn, 1.0, 2e-3) << "48 rows of arms";
}

// 2,000 joints: a percentile of them is known to about 4 % of the band.
TEST(Budget, FirstOrderAgreesWithMonteCarloForSmallTolerances) {
    const double torques[] = {1.0, 1.5};
    const Budget budget = budget_of(pnrvsa().subject(scaled(0.2)), torques, {.draws = 2000});
    for (const PartBudget& part : budget.parts)
        for (const TorqueError& place : part.places) {
            if (&place == &part.places.back()) continue;  // beyond its end the law is continued by a chord
            EXPECT_NEAR(place.sampled.low / place.band.low, 1.0, 0.08) << to_string(part.kind) << " at " << place.travel;
            EXPECT_NEAR(place.sampled.high / place.band.high, 1.0, 0.08) << to_string(part.kind) << " at " << place.travel;
        }
    for (const WidthBudget& width : budget.widths) EXPECT_NEAR(width.sampled.width() / width.band.width(), 1.0, 0.08) << width.tau;
}

TEST(Budget, IsTheSameForAnyNumberOfThreads) {
    const double torques[] = {1.0};
    const Budget one = budget_of(pnrvsa().subject({}), torques, {.draws = 40, .jobs = 1}),
                 four = budget_of(pnrvsa().subject({}), torques, {.draws = 40, .jobs = 4});
    for (std::size_t part = 0; part < 2; ++part)
        for (std::size_t i = 0; i < one.parts[part].places.size(); ++i)
            EXPECT_EQ(one.parts[part].places[i].sampled.high, four.parts[part].places[i].sampled.high);
    EXPECT_EQ(one.widths.front().sampled.low, four.widths.front().sampled.low);
}

// With one source at the tolerance that it needs alone, the band is the wanted one at its widest place.
TEST(Needed, GivesTheWantedBand) {
    const Subject subject = pnrvsa().subject({});
    const PartBudget part = budget_of(subject, {}, {.draws = 0}).parts[1];
    const std::vector<Needed> needed = tolerances_for_torque(part, 0.05);
    ASSERT_GE(needed.size(), 6U);
    for (const Needed& n : needed) {
        if (n.source != Source::kContour && n.source != Source::kRate) continue;
        Tolerances only = none();
        (n.source == Source::kContour ? only.contour : only.rate) = n.alone;
        EXPECT_NEAR(budget_of(pnrvsa().subject(only), {}, {.draws = 0}).parts[1].worst().band.high, 0.05, 1e-9) << to_string(n.source);
        EXPECT_LT(n.shared, n.alone);
    }
}

TEST(Budget, RefusesToleranceBelowZero) {
    Tolerances bad;
    bad.runout = -1e-3;
    EXPECT_THROW(static_cast<void>(budget_of(pnrvsa().subject(bad), {}, {.draws = 0})), core::InvalidInput);
    EXPECT_THROW(static_cast<void>(budget_of(pnrvsa().subject({}), {}, {.draws = 5})), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::design::budget
