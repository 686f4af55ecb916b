#include <gtest/gtest.h>

#include "checks/fixture.h"

// Known: what stands inside a torsion spring is the axle of its spool, unless the profile states a sleeve on it or turns it down.
namespace fusee::checks {
namespace {

const Rule& rule() {
    for (const Rule& one : rules())
        if (one.id == std::string("spring.rod")) return one;
    throw std::logic_error("no rule spring.rod");
}

/// Coils of 12 x 10/(10 + 10/(2 pi)) - 1.2 = 9.152370 mm inside, wound to 10 rad, over an axle.
Fixture on_axle(double axle_mm, double rod_mm) {
    Fixture b = spool();
    b.spring.active_coils = 10.0;
    b.part.options.hub.bore_diameter = axle_mm * kMm;
    b.spring.rod_diameter = rod_mm * kMm;
    return b;
}

core::Finding judged(const Fixture& b) {
    const core::Findings all = rule().run(b.design());
    return all.size() == 1 ? all.front() : core::Finding{};
}

void expect_judged(const Fixture& b, core::Severity severity, double inside_mm, const std::string& what) {
    const core::Finding f = judged(b);
    EXPECT_EQ(f.severity, severity) << core::to_line(f);
    EXPECT_NEAR(f.measured, 9.1523700 / inside_mm, 1e-6);
    EXPECT_NE(f.what.find(what), std::string::npos) << f.what;
}

TEST(SpringRod, JudgesTheAxleThatGoesThroughTheSpool) {
    expect_judged(on_axle(9.5, 0.0), core::Severity::kError, 9.5, "that of the axle, 9.5 mm");
    expect_judged(on_axle(6.0, 0.0), core::Severity::kPass, 6.0, "that of the axle, 6 mm");
}

TEST(SpringRod, JudgesASleeveOrTheAxleTurnedDown) {
    expect_judged(on_axle(6.0, 9.0), core::Severity::kWarning, 9.0, "that of the sleeve on the axle, 9 mm");
    expect_judged(on_axle(9.5, 8.0), core::Severity::kPass, 8.0, "that of the axle, turned down there, 8 mm");
}

TEST(SpringRod, WhatItSuggestsForAThickAxleTurnsItDown) {
    const core::Finding bad = judged(on_axle(9.5, 0.0));
    ASSERT_EQ(bad.suggestion.text(), "k_se.spring.rod_mm = 9.15") << "rounded down";
    EXPECT_NE(judged(on_axle(9.5, 9.15)).severity, core::Severity::kError);
}

TEST(SpringRod, OfAnOverhungSpoolIsNotJudgedWithoutAnArbor) {
    Fixture b = on_axle(6.0, 0.0);
    b.part.options.hub.kind = solid::HubKind::kOverhung;
    EXPECT_EQ(judged(b).severity, core::Severity::kNotJudged);
    b.spring.rod_diameter = 8.0 * kMm;
    expect_judged(b, core::Severity::kPass, 8.0, "that of the arbor, 8 mm");
}

}  // namespace
}  // namespace fusee::checks
