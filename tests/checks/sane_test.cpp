#include <gtest/gtest.h>

#include "checks/fixture.h"

// A usual part must have no errors, and data that are not stated must not be judged.
namespace fusee::checks {
namespace {

core::Findings forbidden(const core::Findings& findings) {
    core::Findings some;
    for (const core::Finding& f : findings)
        if (f.severity == core::Severity::kError) some.push_back(f);
    return some;
}

std::string lines(const core::Findings& findings) {
    std::string text;
    for (const core::Finding& f : findings) text += core::to_line(f) + "\n";
    return text;
}

/// Printed K_PE whose arm grows from 3 to 9.5 mm over one and a half turns, h = 3 + 6.5 x^2, rho = h + 13/width^2 > h.
Fixture growing_cam() {
    Fixture b = pusher();
    const double width = 3.0 * core::kPi, pitch = 4.0 * kMm;
    b.part.cam.anchor_psi = -0.8;  // arms of 3 mm: the default 20 deg would put the hole into the working floor
    b.part.cam.path = [=](double psi) {
        const double x = psi / width;
        const double bend = 13.0 * kMm / (width * width), h = 3.0 * kMm + 0.5 * bend * psi * psi;
        return cam::PathPoint{psi, h, 13.0 * kMm * x / width, h + bend, pitch * psi / (2.0 * core::kPi)};
    };
    work(b, 0.0, width, 20.0 * kMm);
    b.part.mesh = box({-1, -1, -4}, {1, 1, 10});
    return b;
}

TEST(Sane, PrintedSpoolHasNothingToChange) {
    const core::Findings findings = check(spool().design());
    EXPECT_EQ(lines(forbidden(findings)), "");
    EXPECT_GE(findings.size(), 20u) << "passes are reported with their margin";
}

TEST(Sane, PrintedHelicalCamHasNothingToChange) { EXPECT_EQ(lines(forbidden(check(growing_cam().design()))), ""); }

TEST(Sane, MilledSpoolHasNothingToChange) { EXPECT_EQ(lines(forbidden(check(milled().design()))), ""); }

// DIN 6892 is for metals; a pressure that the user states is the limit as it stands.
TEST(Sane, AKeyHasItsReserveInMetals) {
    Fixture b = spool();
    b.cable.max_pressure = 0.0;
    EXPECT_NEAR(worst("shaft.key_pressure", b).allowed, 60.0, 1e-9) << "pla";
    b.process.kind = ProcessKind::kMill4;
    EXPECT_NEAR(worst("shaft.key_pressure", b).allowed, 0.9 * 250.0, 1e-9) << "aluminium";
    EXPECT_NE(worst("shaft.key_pressure", b).what.find("aluminium, 250 MPa, is 5.18 times that"), std::string::npos);  // of 48.232875
    b.cable.max_pressure = 30e6;
    EXPECT_NEAR(worst("shaft.key_pressure", b).allowed, 30.0, 1e-9);
}

TEST(Sane, UnknownDataIsNotJudged) {
    Fixture b = spool();
    b.cable.breaking_load = b.cable.max_pressure = 0.0;
    b.spring = {};
    b.spring.rate = 0.02;
    b.part.mesh = {};
    for (const char* rule : {"spring.rate", "spring.torsion_angle", "spring.load", "spring.stress"})
        EXPECT_EQ(worst(rule, b).severity, core::Severity::kNotJudged) << rule;
    for (const char* rule : {"spring.travel", "spring.buckling", "cable.free_path", "process.build_volume", "fdm.support"})
        EXPECT_TRUE(run_rule(rule, b).empty()) << rule << " does not apply to a torsion spring, or to a part without a mesh";
    Fixture compression = pusher();
    compression.spring = {};
    compression.spring.kind = spring::BaseKind::kCompression;
    compression.spring.rate = 7460.0;
    for (const char* rule : {"spring.travel", "spring.load", "spring.stress", "spring.buckling"})
        EXPECT_EQ(worst(rule, compression).severity, core::Severity::kNotJudged) << rule;
}

TEST(Sane, RulesOfOneKindOfPartLeaveTheOtherAlone) {
    for (const char* rule : {"groove.pitch", "groove.neighbour_turns", "cable.groove_angle", "collision.rim_undercut",
                             "collision.ball_cutter", "spring.travel"})
        EXPECT_TRUE(run_rule(rule, spool()).empty()) << rule;
    Fixture resin = spool();
    resin.process.kind = ProcessKind::kSla;
    for (const char* rule : {"collision.printed_throat", "fdm.support"}) EXPECT_TRUE(run_rule(rule, resin).empty()) << rule;
}

// A groove that rises by 5.2 deg towards its guide: the cable leaves along it. From the contact's plane that is above both limits.
TEST(Sane, TheFleetAngleOfAnAimedGrooveIsFromItsDirection) {
    Fixture b = helix(10 * kMm, 5.72 * kMm);
    const double slope = std::atan(5.72 / (20.0 * core::kPi));
    const auto lean_all = [&b](double fleet) {
        for (cam::Contact& contact : b.part.cam.working) contact.fleet = b.part.cam.options.torque_sign * fleet;
    };
    lean_all(slope);
    EXPECT_EQ(worst("cable.fleet", b).severity, core::Severity::kError) << "of a constant pitch";
    b.part.cam.options.path.lead = cam::Lead::kAimedAtGuide;
    EXPECT_NEAR(worst("cable.fleet", b).measured, 0.0, 1e-6);
    EXPECT_NEAR(worst("cable.fleet_side", b).measured, 0.0, 1e-6);
    lean_all(-slope);
    EXPECT_EQ(worst("cable.fleet", b).severity, core::Severity::kError) << "away from the groove";
}

TEST(Sane, NotANumberNeverPasses) {
    Fixture b = spool();
    b.part.cam.working[5].path.rho = b.part.cam.working[5].fleet = std::nan("");
    EXPECT_EQ(worst("cable.bend_ratio", b).severity, core::Severity::kError);
    EXPECT_EQ(worst("cable.fleet", b).severity, core::Severity::kError);
}

}  // namespace
}  // namespace fusee::checks
