#include "fusee/cam/certificate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <future>
#include <random>

#include "fixture.h"
#include "fusee/core/error.h"
#include "fusee/spring/law.h"
#include "fusee/spring/laws.h"

namespace fusee::cam {
namespace {

using namespace test;
using math::Interval;
using math::Jet;

constexpr double kCertifiedTurn = 2.0 * core::kPi;

/// A contour by hand: one working stretch over a whole turn, psi its own parameter.
template <class Rho>
std::vector<ContourPiece> contour(const Rho& rho, core::Range psi = {0.0, kCertifiedTurn}) {
    return {{psi, true, [rho](const Interval& box) {
                 ContourJet at;
                 at.psi = at.angle = Jet::parameter(box);
                 at.rho = rho(at.psi);
                 return at;
             }}};
}

Jet cosine(const Jet& x) { return {boost::numeric::cos(x.value), -boost::numeric::sin(x.value) * x.slope}; }

TEST(Certificate, OfACircleIsItsRadius) {
    const Certificate c = certify(contour([](const Jet&) { return Jet(0.0125); }), false);
    EXPECT_EQ(c.convex, Proof::kProven);
    EXPECT_EQ(c.ordered, Proof::kProven);
    EXPECT_NEAR(c.least().proven, 0.0125, 1e-17);
    EXPECT_LE(c.least().proven, 0.0125);
    EXPECT_GE(c.least().found, 0.0125);
    EXPECT_TRUE(c.open.empty()) << c.open;
}

// Half axes a > b: h = sqrt(a^2 cos^2 psi + b^2 sin^2 psi), rho = (a b)^2/h^3, least b^2/a at psi = 0 and pi.
TEST(Certificate, OfAnEllipseEnclosesItsLeastRadius) {
    const double a = 0.020, b = 0.012, truth = b * b / a;
    const auto ellipse = [=](const Jet& psi) {
        const Jet h = sqrt(b * b + (a * a - b * b) * cosine(psi) * cosine(psi));
        return a * a * b * b / cube(h);
    };
    const Certificate c = certify(contour(ellipse, {-1.0, kCertifiedTurn - 1.0}), false);
    EXPECT_EQ(c.convex, Proof::kProven);
    EXPECT_LE(c.working.proven, truth);
    EXPECT_GE(c.working.found, truth);
    EXPECT_LT(c.working.found - c.working.proven, 1e-4 * truth);
    const double apex = std::round(c.working.psi.low / core::kPi) * core::kPi;  // rho exceeds the least by x^2 of itself
    EXPECT_LT(std::abs(c.working.psi.low - apex), 0.1);
    EXPECT_LT(c.boxes, 1000);
}

// A dent of a milliradian amid two whole degrees: sampling each degree sees a circle.
TEST(Certificate, RefusesADentThatSamplingMisses) {
    const double radius = 0.010, place = core::rad_from_deg(57.5), width = 1e-3;
    const auto dented = [=](const auto& psi) {
        using std::exp;
        const auto x = (psi - place) / width;
        return radius * (1.0 - 1.2 * exp(-x * x));
    };
    double sampled = 1.0;
    for (int degree = 0; degree < 360; ++degree) sampled = std::min(sampled, dented(core::rad_from_deg(degree)));
    EXPECT_NEAR(sampled, radius, 1e-15);
    const Certificate c = certify(contour(dented), false);
    EXPECT_EQ(c.convex, Proof::kRefuted);
    EXPECT_NEAR(c.working.found, -0.2 * radius, 1e-4 * radius);
    EXPECT_NEAR(c.working.psi.low, place, width);
    EXPECT_NE(c.open.find("convexity is refuted at psi 1.00"), std::string::npos) << c.open;
}

TEST(Certificate, NamesTheBoxAtWhichItStopped) {
    const auto wavy = [](const Jet& psi) { return 0.1 * (0.26 - cosine(psi) + cosine(psi) * cosine(psi)); };  // >= 1 mm
    const Certificate c = certify(contour(wavy), false, {.most_boxes = 5});
    EXPECT_EQ(c.convex, Proof::kNotProven);
    EXPECT_LE(c.working.proven, 0.0);
    EXPECT_NE(c.open.find("convexity is not proven at psi"), std::string::npos) << c.open;
    EXPECT_EQ(certify(contour(wavy), false).convex, Proof::kProven);
    EXPECT_THROW((void)certify(contour(wavy), false, {.gap = 0.0}), core::InvalidInput);
}

TEST(Certificate, SeesThatTheCableUnrollsOutOfOrder) {
    auto folded = contour([](const Jet&) { return Jet(0.01); });
    folded.front().over = [](const Interval& box) {
        ContourJet at;
        at.angle = Jet::parameter(box);
        at.psi = at.angle + 1.01 * cosine(at.angle);  // turns back for an eighth of a radian around pi/2
        at.rho = Jet(0.01);
        return at;
    };
    const Certificate c = certify(folded, false);
    EXPECT_EQ(c.ordered, Proof::kRefuted);
    EXPECT_NEAR(c.working.proven, 0.01, 1e-16);
}

/// A law with values at points only.
class Callable final : public spring::SpringLaw {
public:
    [[nodiscard]] core::Range loads() const override { return law_->loads(); }
    [[nodiscard]] core::Range angles() const override { return law_->angles(); }
    [[nodiscard]] spring::LawPoint at_load(double tau) const override { return law_->at_load(tau); }
    [[nodiscard]] spring::LawPoint at_angle(double theta) const override { return law_->at_angle(theta); }

private:
    spring::SpringLawPtr law_ = stiction_law();
};

TEST(Certificate, ProvesNothingFromPointsAlone) {
    const ArmFunction arm(PartKind::kSeries, std::make_shared<Callable>(), torsion(), kCapstan);
    for (const Certificate& c : {certify(synthesize_cam(arm, {}).value()), certify(Cam{})}) {
        EXPECT_EQ(c.convex, Proof::kNotProven);
        EXPECT_EQ(c.ordered, Proof::kNotProven);
        EXPECT_NE(c.open.find("has no bounds"), std::string::npos) << c.open;
    }
}

struct CertifiedCam {
    const char* name;
    ArmFunction arm;
    CamOptions options;
};

CamOptions towards(GuideKind kind, PathKind path = PathKind::kPlanar, Lead lead = Lead::kConstantPitch) {
    CamOptions o;
    o.guide = {.kind = kind, .direction = 1.2, .distance = 0.12, .radius = 0.008, .sense = -1, .z = 0.03};
    o.path.kind = path;
    o.path.lead = lead;
    o.path.pitch = 0.003;
    return o;
}

/// Every kind of law, guide and path.
std::vector<CertifiedCam> cases() {
    const auto led_in = spring::with_lead_in(stiction_law(), 0.05).value();
    const auto wanted = spring::make_dead_band_law({.dead_band = math::make_formula("dead_band", "0.838*tau^-2.2", "tau", {0.6, 2.09}),
                                                    .series_stiffness = math::make_formula("s", "0.22*tau^2", "tau", {0.6, 2.09}),
                                                    .start_torque = 0.6,
                                                    .end_torque = 2.09})
                            .value();
    const auto affine = spring::make_general_stiction_law({.k = 0.225,
                                                           .u = 0.0012,
                                                           .c = 0.265,
                                                           .friction = spring::FrictionLaw::affine(0.004, 0.275, 0.01),
                                                           .start_torque = 0.6,
                                                           .end_torque = 2.0})
                            .value();
    const std::vector<double> loads{0.6, 0.9, 1.2, 1.5, 1.8, 2.09};
    std::vector<double> s, t;
    for (const double tau : loads) s.push_back(0.225 * tau * tau), t.push_back(0.265 / tau);
    const auto knots = spring::make_free_curve({loads, s, t}).value();
    const ArmFunction behind(PartKind::kSeries, led_in, torsion(), kCapstan, {.radius = 2e-4, .series_compliance = 0.05});
    const auto series = [](const spring::SpringLawPtr& law) { return ArmFunction(PartKind::kSeries, law, torsion(), kCapstan); };
    const auto parallel = [](const spring::SpringLawPtr& law) { return ArmFunction(PartKind::kParallel, law, compression(), kCapstan); };
    return {{"lead-in, parallel guide", series(led_in), {}},
            {"lead-in, idler", parallel(led_in), towards(GuideKind::kIdler)},
            {"behind a cable, point", behind, towards(GuideKind::kPoint)},
            {"dead-band formula", series(wanted), towards(GuideKind::kIdler)},
            {"affine friction", parallel(affine), {}},
            {"knots", series(knots), {}},
            {"polynomial, helix", long_parallel_arm(), towards(GuideKind::kPoint, PathKind::kHelix)},
            {"polynomial, aimed helix", long_parallel_arm(), towards(GuideKind::kPoint, PathKind::kHelix, Lead::kAimedAtGuide)}};
}

// The bounds are those of the geometry: at any parameter the path lies inside the bounds over any box around it.
TEST(Certificate, BoundsThePathItself) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (const CertifiedCam& item : cases()) {
        SCOPED_TRACE(item.name);
        const auto made = synthesize_cam(item.arm, item.options);
        ASSERT_TRUE(made) << made.refusal().front().what << made.refusal().front().suggestion.text();
        const Cam& cam = *made;
        for (const ContourPiece& s : cam.pieces())
            for (int i = 0; i < 10; ++i) {
                const double q = std::lerp(s.parameter.low, s.parameter.high, share(random)), reach = std::pow(10.0, -6.0 * share(random));
                const Interval box(std::lerp(q, s.parameter.low, reach), std::lerp(q, s.parameter.high, reach));
                const ContourJet wide = s.over(box), here = s.over(Interval(q));
                const double psi = math::middle(here.psi.value);
                const PathPoint point = cam.path(psi);
                // The path solves for its load to the last bits; rho changes with the remaining error.
                EXPECT_NEAR(math::middle(here.rho.value), point.rho, 1e-8 * point.rho + 1e-12) << q;
                EXPECT_TRUE(boost::numeric::subset(here.rho.value, wide.rho.value)) << q;
                EXPECT_TRUE(boost::numeric::subset(here.rho.slope, wide.rho.slope)) << q;
                EXPECT_TRUE(boost::numeric::subset(here.psi.value, wide.psi.value)) << q;
                EXPECT_LT(boost::numeric::width(here.rho.value), 1e-9) << q;
            }
    }
}

TEST(Certificate, IsTightForEveryKindOfLawAndPath) {
    for (const CertifiedCam& item : cases()) {
        SCOPED_TRACE(item.name);
        const Cam cam = synthesize_cam(item.arm, item.options).value();
        const Certificate c = certify(cam);
        EXPECT_EQ(c.convex, Proof::kProven) << c.open;
        EXPECT_EQ(c.ordered, Proof::kProven) << c.open;
        EXPECT_TRUE(c.open.empty()) << c.open;
        double sampled = 1.0;
        constexpr int kPlaces = 5000;
        const core::Range psi = cam.working_psi;
        for (int i = 0; i <= kPlaces; ++i) sampled = std::min(sampled, cam.path(psi.low + psi.width() * i / kPlaces).rho);
        EXPECT_LE(c.working.proven, sampled);
        EXPECT_LE(c.working.found - c.working.proven, 1e-4 * c.working.found);
        EXPECT_NEAR(c.working.proven, sampled, 1e-3 * sampled);
        EXPECT_LT(c.seam, 1e-9);
    }
}

/// Radius of curvature in space of the groove's floor, by differences of its points.
double floor_radius(const Cam& cam, double psi) {
    const double step = 1e-4, depth = 0.5 * cam.options.cable_diameter;
    const auto point = [&](double at) {
        const PathPoint p = cam.path(at);
        return std::array{p.x() - depth * std::cos(at), p.y() - depth * std::sin(at), p.z};
    };
    const auto a = point(psi - step), b = point(psi), c = point(psi + step);
    std::array<double, 3> d1{}, d2{};
    for (std::size_t i = 0; i < 3; ++i) d1[i] = (c[i] - a[i]) / (2 * step), d2[i] = (c[i] - 2 * b[i] + a[i]) / (step * step);
    const std::array cross{d1[1] * d2[2] - d1[2] * d2[1], d1[2] * d2[0] - d1[0] * d2[2], d1[0] * d2[1] - d1[1] * d2[0]};
    const double speed = std::hypot(d1[0], d1[1], d1[2]);
    return speed * speed * speed / std::hypot(cross[0], cross[1], cross[2]);
}

TEST(Certificate, OfAHelixKnowsItsRadiusInSpace) {
    for (const Lead lead : {Lead::kConstantPitch, Lead::kAimedAtGuide}) {
        CamOptions o = towards(GuideKind::kPoint, PathKind::kHelix, lead);
        o.path.pitch = 0.02;  // steep, so that space differs from the plane
        o.guide.z = 0.06;
        const Cam cam = synthesize_cam(long_parallel_arm(), o).value();
        const Certificate c = certify(cam);
        ASSERT_TRUE(c.floor);
        EXPECT_TRUE(c.open.empty()) << c.open;
        double sampled = 1.0;
        const core::Range arc = cam.working_psi;
        for (double psi = arc.low + 1e-3; psi < arc.high - 1e-3; psi += 1e-3) sampled = std::min(sampled, floor_radius(cam, psi));
        EXPECT_NEAR(c.floor->proven, sampled, 2e-3 * sampled);  // the gap in space is 1e-3; differences err by step^2
        EXPECT_GT(c.floor->proven, 1.02 * (c.working.proven - 0.5 * cam.options.cable_diameter));  // a helix is flatter than its plan
    }
}

// With a constant pitch the groove's direction turns as fast as rho changes. The change must be slow enough that the groove is not sharp in
// space.
TEST(Certificate, OfAHelixKnowsThatItsRunOutIsNotSharp) {
    for (const double pitch : {4e-3, 0.02}) {
        CamOptions o = towards(GuideKind::kPoint, PathKind::kHelix);
        o.path.pitch = pitch;
        const Cam cam = synthesize_cam(long_parallel_arm(), o).value();
        const Certificate c = certify(cam);
        double sampled = 1.0;
        for (double psi = cam.groove_psi.low; psi < cam.working_psi.low; psi += 1e-3) sampled = std::min(sampled, floor_radius(cam, psi));
        for (double psi = cam.working_psi.high; psi < cam.groove_psi.high; psi += 1e-3) sampled = std::min(sampled, floor_radius(cam, psi));
        ASSERT_TRUE(c.idle_floor);
        EXPECT_LE(c.idle_floor->proven, 1.001 * sampled);
        EXPECT_NEAR(c.idle_floor->proven, sampled, 0.02 * sampled);  // differences round off the knots
        EXPECT_GT(c.idle_floor->proven, 0.9 * (c.idle->proven - 0.5 * cam.options.cable_diameter)) << pitch;
    }
}

TEST(Certificate, MeasuresTheSeamOfAPlanarContour) {
    Cam cam = synthesize_cam(series_arm(), {}).value();
    EXPECT_LT(certify(cam).seam, 1e-12);
    cam.path = [path = cam.path, high = cam.working_psi.high](double psi) {
        PathPoint point = path(psi);
        if (psi > high) point.h += 1e-5;
        return point;
    };
    EXPECT_NEAR(certify(cam).seam, 1e-5, 1e-9);
}

TEST(Certificate, IsTheSameOnEveryThread) {
    const Cam cam = synthesize_cam(series_arm(), {}).value();
    const Certificate one = certify(cam);
    std::vector<std::future<Certificate>> others;
    for (int i = 0; i < 4; ++i) others.push_back(std::async(std::launch::async, [&cam] { return certify(cam); }));
    for (auto& other : others) {
        const Certificate c = other.get();
        EXPECT_EQ(c.boxes, one.boxes);
        EXPECT_EQ(c.working.proven, one.working.proven);
        EXPECT_EQ(c.idle->found, one.idle->found);
        EXPECT_EQ(c.working.psi.low, one.working.psi.low);
    }
}

}  // namespace
}  // namespace fusee::cam
