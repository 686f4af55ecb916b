#include <gtest/gtest.h>

#include <cstdlib>

#include "checks/fixture.h"

// Law: a suggested change, made, satisfies the rule that suggested it.
namespace fusee::checks {
namespace {

/// The number behind `key = ` in a suggestion.
double suggested(const core::Finding& f, const std::string& key) {
    const std::size_t at = f.suggestion.find(key + " = ");
    EXPECT_NE(at, std::string::npos) << key << " in " << f.suggestion;
    return at == std::string::npos ? std::nan("") : std::strtod(f.suggestion.c_str() + at + key.size() + 3, nullptr);
}

/// The same law on another base spring: the energy of every position stays.
void respring(Bench& b, double rate, double preload) {
    for (cam::Contact& c : b.part.cam.working) {
        const double energy = 0.5 * b.spring.rate * (c.arm.state * c.arm.state - b.spring.preload * b.spring.preload);
        c.arm.state = std::sqrt(preload * preload + 2.0 * energy / rate);
    }
    b.spring.rate = rate;
    b.spring.preload = preload;
}

void expect_pass(const char* rule, const Bench& b) {
    const core::Finding f = gravest(rule, b);
    EXPECT_EQ(f.severity, core::Severity::kPass) << core::to_line(f);
}

TEST(Suggestion, ThinnerCableBendsEnough) {
    Bench b = spool();
    for (cam::Contact& c : b.part.cam.working) c.path.rho = 2.2 * kMm;
    b.cable.min_bend_ratio = 8.0;
    b.cable.diameter = kMm * suggested(gravest("cable.bend_ratio", b), "cable.diameter_mm");
    expect_pass("cable.bend_ratio", b);
    EXPECT_GT(b.cable.diameter, 0.48 * kMm) << "the nearest: 2 rho/9 = 0.489 mm";
}

TEST(Suggestion, TorsionPreloadOrRateKeepsTheWinding) {
    Bench preload = spool();
    preload.spring.max_state = 9.5;
    Bench rate = preload;
    const core::Finding f = gravest("spring.torsion_angle", preload);
    respring(preload, preload.spring.rate, suggested(f, "k_se.spring.preload_rad"));
    respring(rate, suggested(f, "k_se.spring.rate_Nm_per_rad"), rate.spring.preload);
    expect_pass("spring.torsion_angle", preload);
    expect_pass("spring.torsion_angle", rate);
}

TEST(Suggestion, CompressionPreloadOrRateKeepsTheTravel) {
    Bench preload = pusher();
    preload.spring.max_state = 18.0 * kMm;
    Bench rate = preload;
    const core::Finding f = gravest("spring.travel", preload);
    respring(preload, preload.spring.rate, kMm * suggested(f, "k_pe.spring.preload_mm"));
    respring(rate, suggested(f, "k_pe.spring.rate_N_per_m"), rate.spring.preload);
    expect_pass("spring.travel", preload);
    expect_pass("spring.travel", rate);
}

TEST(Suggestion, SofterSpringKeepsLoadAndStress) {
    Bench load = pusher(), stress = pusher();
    load.spring.max_load = 140.0;
    stress.spring.tensile_strength = 1900e6;
    respring(load, suggested(gravest("spring.load", load), "k_pe.spring.rate_N_per_m"), load.spring.preload);
    respring(stress, stress.spring.rate, kMm * suggested(gravest("spring.stress", stress), "k_pe.spring.preload_mm"));
    expect_pass("spring.load", load);
    expect_pass("spring.stress", stress);
}

/// r = sqrt((k_t phi0)^2 + 2 k_t U)/U' and U'/sqrt((k y0)^2 + 2 k U): the suggested spring scales every arm alike.
TEST(Suggestion, ScaledSpringScalesEveryArm) {
    Bench b = spool();
    b.part.options.hub.bore_diameter = 18.0 * kMm;
    const core::Finding f = gravest("cam.arm_range", b);
    const double rate = suggested(f, "k_se.spring.rate_Nm_per_rad");
    const double factor = f.allowed / f.measured;
    Bench scaled = spool();
    respring(scaled, rate, b.spring.preload / factor);
    for (std::size_t i = 0; i < b.part.cam.working.size(); i += 20) {
        const double before = b.spring.rate * b.part.cam.working[i].arm.state, after = rate * scaled.part.cam.working[i].arm.state;
        EXPECT_NEAR(after / before, factor, 2e-4 * factor) << "the rate is printed with four digits";
    }
}

TEST(Suggestion, GrooveAndHubSizesPass) {
    Bench b = helix(10.0 * kMm, 3.0 * kMm);
    expect_pass("groove.pitch", helix(10.0 * kMm, kMm * (suggested(gravest("groove.pitch", b), "k_pe.path.pitch_mm") + 0.2)));
    Bench thin = spool();
    thin.part.options.hub.bore_diameter = 15.0 * kMm;
    thin.part.options.hub.bore_diameter = kMm * suggested(gravest("structure.wall_to_bore", thin), "k_se.hub.bore_mm");
    expect_pass("structure.wall_to_bore", thin);
    Bench slot = spool();
    slot.part.options.features.leg_slot_radius = 6.6 * kMm;
    slot.part.options.features.leg_slot_radius = kMm * suggested(gravest("structure.leg_slot", slot), "k_se.features.leg_slot_radius_mm");
    expect_pass("structure.leg_slot", slot);
    Bench throat = spool();
    throat.part.options.groove.throat = core::rad_from_deg(60.0);
    cut_groove(throat);
    throat.part.options.groove.throat = core::rad_from_deg(suggested(gravest("process.overhang", throat), "groove.throat_deg"));
    cut_groove(throat);
    expect_pass("process.overhang", throat);
    expect_pass("groove.throat", throat);
}

TEST(Suggestion, ThickerCablePressesLess) {
    Bench b = spool();
    b.cable.max_pressure = 5e6;
    b.cable.diameter = kMm * suggested(gravest("cable.pressure", b), "cable.diameter_mm");
    expect_pass("cable.pressure", b);
}

}  // namespace
}  // namespace fusee::checks
