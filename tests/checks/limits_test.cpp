#include "fusee/checks/limits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "checks/fixture.h"
#include "fusee/core/error.h"
#include "fusee/core/units.h"

namespace fusee::checks {
namespace {

TEST(Limits, StrengthLeftMeetsItsTable) {
    EXPECT_DOUBLE_EQ(strength_left("7x7", 40.0), 0.95);
    EXPECT_DOUBLE_EQ(strength_left("7x7", 10.0), 0.86);
    EXPECT_DOUBLE_EQ(strength_left("7x7", 1.0), 0.50);
    EXPECT_DOUBLE_EQ(strength_left("7x7", 1000.0), 0.95) << "no more beyond the table";
    EXPECT_DOUBLE_EQ(strength_left("7x7", 0.1), 0.50);
    EXPECT_NEAR(strength_left("7x7", std::sqrt(200.0)), 0.885, 1e-12) << "half way in the logarithm from 10 to 20";
}

TEST(Limits, StrengthLeftRisesWithTheBend) {
    for (double ratio = 0.5; ratio < 60.0; ratio *= 1.1) EXPECT_LE(strength_left("7x7", ratio), strength_left("7x7", 1.1 * ratio)) << ratio;
}

TEST(Limits, FibreHasItsOwnTable) {
    EXPECT_DOUBLE_EQ(strength_left("fibre", 4.0), 0.80);
    EXPECT_DOUBLE_EQ(strength_left("fibre", 40.0), 0.95);
    EXPECT_LT(strength_left("7x7", 4.0), strength_left("fibre", 4.0));
}

TEST(Limits, EveryCableHasEachTermination) {
    for (const CableLimits& row : cable_table())
        for (const Termination kind : {Termination::kKnot, Termination::kCrimp, Termination::kSplice}) {
            Cable cable;
            cable.construction = row.construction;
            cable.termination = kind;
            EXPECT_EQ(termination_limits(cable).kind, kind) << row.construction;
            EXPECT_EQ(termination_limits(cable).fibre, row.is_fibre()) << row.construction;
        }
}

// A good and two bad twins of each pair of cable and material, 5 % beside its limits; the floor has 19.2 mm, p = 2T/(19.2 mm 0.8 mm).
TEST(Limits, EveryPairOfCableAndMaterialHasItsPressure) {
    struct Pair {
        const char *cable, *material;
        double review, required;  // [MPa]
    };
    const std::array pairs{
        Pair{"fibre", "pla", 60.0, 90.0},         Pair{"7x19", "pla", 60.0, 90.0},       Pair{"7x19", "pa12", 52.0, 78.0},
        Pair{"fibre", "aluminium", 250.0, 375.0}, Pair{"7x7", "aluminium", 2.03, 375.0}, Pair{"7x19", "aluminium", 3.31, 375.0},
        Pair{"7x49", "aluminium", 3.95, 375.0},   Pair{"fibre", "steel", 235.0, 352.5},  Pair{"7x7", "steel", 3.79, 352.5},
        Pair{"7x19", "steel", 6.21, 352.5},       Pair{"7x49", "steel", 7.41, 352.5}};
    for (const Pair& pair : pairs) {
        SCOPED_TRACE(std::string(pair.cable) + " on " + pair.material);
        Fixture b = spool();
        b.cable.construction = pair.cable, b.cable.max_pressure = 0.0, b.process.material.kind = pair.material;
        const auto under = [&](double pressure_MPa) {
            for (cam::Contact& c : b.part.cam.working) c.arm.tension = 0.5 * pressure_MPa * 19.2 * 0.8;
            return worst("cable.pressure", b);
        };
        EXPECT_NEAR(under(0.95 * pair.review).allowed, pair.review, 0.02) << "550, 900 and 1075 psi, 8/15 of them on aluminium";
        EXPECT_EQ(under(0.95 * pair.review).severity, core::Severity::kPass);
        EXPECT_EQ(under(1.05 * pair.review).severity, core::Severity::kWarning);
        EXPECT_EQ(under(0.95 * pair.required).severity, core::Severity::kWarning);
        EXPECT_EQ(under(1.05 * pair.required).severity, core::Severity::kError);
        b.cable.max_pressure = 10e6;
        EXPECT_EQ(under(9.5).severity, core::Severity::kPass) << "the profile's own limit takes the place of all";
    }
}

TEST(Limits, MaterialIsThatOfTheProcessUnlessStated) {
    Process process;
    EXPECT_STREQ(material_of(process).name, "pla");
    process.kind = ProcessKind::kMill;
    EXPECT_STREQ(material_of(process).name, "aluminium");
    process.material.kind = "pom";
    const Material pom = material_of(process);
    process.material.strength = 2.0 * pom.strength;
    process.material.modulus = 0.5 * pom.modulus;
    process.material.density = 1500.0;
    const Material own = material_of(process);
    EXPECT_DOUBLE_EQ(own.bearing, 2.0 * pom.bearing);
    EXPECT_DOUBLE_EQ(own.permanent, 2.0 * pom.permanent);
    EXPECT_DOUBLE_EQ(own.creep_modulus, 0.5 * pom.creep_modulus);
    EXPECT_DOUBLE_EQ(own.density, 1500.0);
    process.material.kind = "cheese";
    EXPECT_THROW((void)material_of(process), core::InvalidInput);
}

TEST(Limits, AMissingBreakingLoadIsEstimatedAndSaid) {
    Fixture b = spool();
    EXPECT_EQ(worst("cable.breaking_load", b).what.find("estimate"), std::string::npos);
    b.cable.breaking_load = 0.0;
    const core::Finding f = worst("cable.breaking_load", b);  // 870 N/mm^2 x (0.8 mm)^2 x 0.95/50 N
    EXPECT_NEAR(f.measured, 10.5792, 1e-6);
    for (const char* rule : {"cable.breaking_load", "cable.anchor_load", "cable.bend_life"})
        EXPECT_NE(worst(rule, b).what.find("557 N is an estimate for 0.8 mm of fibre"), std::string::npos) << worst(rule, b).what;
}

TEST(Limits, OwnLimitsReplaceTheTable) {
    Process own;
    own.kind = ProcessKind::kSla;
    EXPECT_DOUBLE_EQ(process_limits(own).loaded_wall, 1.0e-3);
    own.min_wall = 2e-3, own.min_hole = 3e-3, own.max_overhang = 0.5, own.cutter_radius = 4e-3, own.tolerance = 5e-3;
    const ProcessLimits limits = process_limits(own);
    EXPECT_DOUBLE_EQ(limits.wall, 2e-3);
    EXPECT_DOUBLE_EQ(limits.loaded_wall, 2e-3);
    EXPECT_DOUBLE_EQ(limits.hole, 3e-3);
    EXPECT_DOUBLE_EQ(limits.overhang, 0.5);
    EXPECT_DOUBLE_EQ(limits.cutter_radius, 4e-3);
    EXPECT_DOUBLE_EQ(limits.tolerance, 5e-3);
}

TEST(Limits, EveryProcessHasARow) {
    for (const ProcessKind kind : {ProcessKind::kFdm, ProcessKind::kSla, ProcessKind::kSls, ProcessKind::kMill, ProcessKind::kMill4,
                                   ProcessKind::kEdm, ProcessKind::kLaser}) {
        Process process;
        process.kind = kind;
        EXPECT_EQ(process_limits(process).kind, kind) << to_string(kind);
    }
}

TEST(Limits, KeysOfDin6885) {
    struct Row {
        double shaft_mm, width_mm, depth_mm;
    };
    for (const Row& row : {Row{6, 2, 1.0}, Row{8, 2, 1.0}, Row{9, 3, 1.4}, Row{10, 3, 1.4}, Row{12, 4, 1.8}, Row{13, 5, 2.3},
                           Row{17, 5, 2.3}, Row{20, 6, 2.8}, Row{30, 8, 3.3}}) {
        const KeySize* key = key_size(core::m_from_mm(row.shaft_mm));
        ASSERT_NE(key, nullptr) << row.shaft_mm;
        EXPECT_DOUBLE_EQ(core::mm_from_m(key->width), row.width_mm) << row.shaft_mm;
        EXPECT_DOUBLE_EQ(core::mm_from_m(key->hub_depth), row.depth_mm) << row.shaft_mm;
    }
    EXPECT_EQ(key_size(5.9e-3), nullptr);
    EXPECT_EQ(key_size(31e-3), nullptr);
}

TEST(Limits, UnknownConstructionIsRefusedByName) {
    try {
        (void)cable_limits("6x19");
        FAIL();
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.field(), "cable.construction");
        EXPECT_EQ(e.value(), "6x19");
        EXPECT_NE(e.allowed().find("fibre"), std::string::npos);
    }
}

}  // namespace
}  // namespace fusee::checks
