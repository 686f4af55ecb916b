#include "fusee/pipeline/as_exported.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/batch/batch.h"
#include "fusee/cam/arm.h"
#include "fusee/core/error.h"
#include "fusee/core/process.h"
#include "fusee/core/units.h"
#include "fusee/exchange/prusa_slicer.h"
#include "fusee/pipeline/design.h"
#include "fusee/spring/potential.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

/// Both cams of a profile on a law, and files that carry any share of their arms.
struct Joint {
    Joint(const profile::Profile& p, const spring::SpringLawPtr& law) : resolved{p, actuator_of(p, law), law->loads(), {}} {
        constexpr int kRows = 400;
        for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
            const auto part = std::make_shared<solid::Part>();
            part->cam.kind = kind;
            const cam::ArmFunction arm = resolved.arm(kind);
            const double travel = law->angles().high;
            for (int row = 0; row < kRows; ++row)
                part->cam.working.push_back({arm.at_load(law->at_angle(travel * row / (kRows - 1)).tau), {}, 0.0, 0.0});
            PartReport report;
            report.part = part;
            report.spring = resolved.spec(kind).spring;
            design.parts.push_back(report);
        }
    }

    readback::ArmError& add(std::size_t part, const std::string& ending, const std::string& reader, double share = 1.0) {
        design.parts[part].arm_errors.push_back(found(part, cam::to_string(cam_of(part).kind) + ending, reader, share));
        return design.parts[part].arm_errors.back();
    }
    [[nodiscard]] readback::ArmError found(std::size_t part, const std::string& file, const std::string& reader, double share) const {
        readback::ArmError reading;
        reading.file = file;
        reading.reader = reader;
        reading.worst_relative = std::abs(share - 1.0);
        for (const cam::Contact& c : cam_of(part).working) reading.arms_mm.push_back(share * core::mm_from_m(c.arm.arm));
        return reading;
    }
    [[nodiscard]] AsExported compare() const { return as_exported(resolved, design); }

    [[nodiscard]] const cam::Cam& cam_of(std::size_t part) const { return design.parts[part].part->cam; }

    ResolvedDesign resolved;
    DesignReport design;
};

/// Linear springs, each unloaded at deflection 0 of its potential: round cams.
constexpr double kStart = 0.1, kEnd = 3.0, kSeriesRate = 0.3, kParallelRate = 0.5, kMu = 0.28;
profile::Profile linear_profile() {
    profile::Profile p;
    p.rig.capstan_radius = p.rig.joint_radius = 0.03;
    p.rig.gear_friction = kMu;
    p.rig.least_torque = 0.4;
    p.rig.peak_torque = 0.8;
    p.rig.overdrive_torque = 1.2;
    const double unloaded = kStart / (kSeriesRate + kParallelRate);
    p.k_se.spring.rate = 0.02;
    p.k_se.spring.preload = unloaded * std::sqrt(kSeriesRate / 0.02);
    p.k_pe.spring.rate = 3000.0;
    p.k_pe.spring.preload = unloaded * std::sqrt(kParallelRate / 3000.0);
    return p;
}
spring::SpringLawPtr linear_law() {
    return spring::make_pair_law(spring::make_polynomial({0.0, kSeriesRate}), spring::make_polynomial({0.0, kParallelRate}), kStart, kEnd)
        .value();
}
/// docs/theory/dead_band.md: linear springs have (L_high - L_low)/(g P).
double by_hand(double tau, double parallel_rate) { return (tau / (1.0 - kMu) - tau / (1.0 + kMu)) / parallel_rate; }

// Known: with every arm of K_PE 1 % larger P is 1.01^2 as stiff; K_SE does not enter.
TEST(AsExported, ArmsOnePercentTooLargeGiveTheDeadBandKnownByHand) {
    Joint joint(linear_profile(), linear_law());
    joint.add(0, ".stl", "assimp");
    joint.add(1, ".stl", "assimp", 1.01);
    joint.add(0, ".dxf", "dxflib", 1.01);
    const AsExported exported = joint.compare();
    ASSERT_EQ(exported.joints.size(), 2u);
    const JointAsExported &stl = exported.joints[0], &dxf = exported.joints[1];
    ASSERT_EQ(exported.torques, (std::vector<double>{0.4, 0.8, 1.2}));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(exported.nominal[i], by_hand(exported.torques[i], kParallelRate), 1e-9);
        EXPECT_NEAR(stl.dead_band[i], by_hand(exported.torques[i], 1.01 * 1.01 * kParallelRate), 1e-9);
        EXPECT_NEAR(dxf.dead_band[i], exported.nominal[i], 1e-9);
    }
    EXPECT_EQ(stl.series.file, "k_se.stl");
    EXPECT_EQ(stl.parallel.file, "k_pe.stl");
    // k (y0 + 1.01 r theta) 1.01 r over k (y0 + r theta) r at the end, where the preload's share is y0/(y0 + r theta) = kStart/kEnd.
    EXPECT_NEAR(stl.parallel.worst_law, 1.01 * (1.01 - 0.01 * kStart / kEnd) - 1.0, 1e-9);
    EXPECT_NEAR(stl.parallel.worst_arm, 0.01, 1e-12);
    EXPECT_LT(stl.series.worst_law, 1e-9);
    EXPECT_EQ(dxf.parallel.file, "") << "no such file: the nominal law";
    EXPECT_NEAR(exported.worst_change(), 1.0 - 1.0 / (1.01 * 1.01), 1e-8);
}

class OfProfile : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(AsExported, OfProfile, testing::Values("pnrvsa", "first_prototype"),
                         [](const auto& one) { return std::string(one.param); });

// Roundtrip: the law's own arms give the law's own dead-band. 400 rows; the third derivative's jump where the lead-in ends costs the most.
TEST_P(OfProfile, OwnArmsGiveTheNominalDeadBand) {
    const profile::Profile p = profile::read_profile(fixtures::shipped(GetParam()));
    Joint joint(p, resolve(p)->law());
    joint.add(0, ".step", "opencascade");
    joint.add(1, ".step", "opencascade");
    const AsExported exported = joint.compare();
    ASSERT_EQ(exported.joints.size(), 1u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(exported.joints[0].dead_band[i], exported.nominal[i], 1e-6 * exported.nominal[i]) << i;
    EXPECT_LT(exported.joints[0].series.worst_law, 1e-6);
    EXPECT_LT(exported.joints[0].parallel.worst_law, 1e-6);
}

// Springs that end exactly at the widest load of overdrive: arms short by a ten-thousandth do not lose the dead-band, by a tenth they do.
TEST(AsExported, AHairBeyondTheEndTheLawGoesOn) {
    profile::Profile p = linear_profile();
    // The leading capstan stands at x + g q, where the springs would carry (L_low + L_high)/2 + (P + S)(L_high - L_low)/(2 P).
    const double low = p.rig.overdrive_torque / (1.0 + kMu), high = p.rig.overdrive_torque / (1.0 - kMu);
    const double end = 0.5 * (low + high) + (kSeriesRate + kParallelRate) * (high - low) / (2.0 * kParallelRate);
    Joint joint(p, spring::make_pair_law(spring::make_polynomial({0.0, kSeriesRate}), spring::make_polynomial({0.0, kParallelRate}), kStart,
                                         end * (1.0 + 1e-9))
                       .value());
    joint.add(1, ".stl", "assimp", 1.0 - 1e-4);
    joint.add(1, ".3mf", "lib3mf", 0.9);
    const AsExported exported = joint.compare();
    const double short_of = 1.0 - 1e-4;
    EXPECT_NEAR(exported.nominal[2], by_hand(1.2, kParallelRate), 1e-9);
    EXPECT_NEAR(exported.joints[0].dead_band[2], by_hand(1.2, short_of * short_of * kParallelRate), 1e-8);
    EXPECT_TRUE(std::isnan(exported.joints[1].dead_band[2]));
}

TEST(AsExported, OfTwoHalfPlatesTheHigherOneCarriesTheCable) {
    Joint joint(linear_profile(), linear_law());
    joint.add(1, ".ngc", "rs274 lower", 0.99);
    joint.add(1, ".ngc", "rs274 upper", 1.01);
    const AsExported exported = joint.compare();
    ASSERT_EQ(exported.joints.size(), 1u);
    EXPECT_EQ(exported.joints[0].reader, "rs274");
    EXPECT_NEAR(exported.joints[0].dead_band[1], by_hand(0.8, 1.01 * 1.01 * kParallelRate), 1e-9);
}

// The joint of files that are proven mirror images is that of the files that were read; where one part was read itself, it is computed.
TEST(AsExported, ProvenMirrorImagesHaveTheJointOfTheFilesThatWereRead) {
    for (const bool both : {true, false}) {
        Joint joint(linear_profile(), linear_law());
        joint.add(0, ".stl", "assimp", 0.99);
        joint.add(1, ".stl", "assimp", 1.01);
        joint.add(0, "_mirrored.stl", "assimp", 0.99).mirror_of = "k_se.stl";
        readback::ArmError& image = joint.add(1, "_mirrored.stl", "assimp", 1.02);
        if (both) image.mirror_of = "k_pe.stl";  // its own arms do not count: the joint is not computed again
        const AsExported exported = joint.compare();
        ASSERT_EQ(exported.joints.size(), 2u);
        EXPECT_EQ(exported.joints[1].series.file, "k_se_mirrored.stl");
        EXPECT_EQ(exported.joints[1].parallel.file, "k_pe_mirrored.stl");
        const double share = both ? 1.01 : 1.02;
        EXPECT_NEAR(exported.joints[1].dead_band[1], by_hand(0.8, share * share * kParallelRate), 1e-9);
        EXPECT_EQ(exported.joints[1].dead_band == exported.joints[0].dead_band, both);
    }
}

TEST(AsExported, EveryPartIsFoundOnThePlate) {
    Joint joint(linear_profile(), linear_law());
    joint.design.plate_errors = {joint.found(0, "plate.3mf", "lib3mf k_se", 1.0), joint.found(1, "plate.3mf", "lib3mf k_pe", 1.01),
                                 joint.found(1, "plate.3mf", "lib3mf k_pe_mirrored", 0.99)};
    const AsExported exported = joint.compare();
    ASSERT_EQ(exported.joints.size(), 2u) << "agonist's, antagonist's";
    EXPECT_EQ(exported.joints[0].reader, "lib3mf");
    EXPECT_EQ(exported.joints[0].series.file, "plate.3mf");
    EXPECT_NEAR(exported.joints[0].dead_band[1], by_hand(0.8, 1.01 * 1.01 * kParallelRate), 1e-9);
    EXPECT_NEAR(exported.joints[1].dead_band[1], by_hand(0.8, 0.99 * 0.99 * kParallelRate), 1e-9);
}

TEST(AsExported, APrintDoesNotCountAndALostArmIsNamed) {
    Joint joint(linear_profile(), linear_law());
    joint.add(1, ".stl", "assimp", 1.0 + 1e-4);
    joint.add(1, ".gcode", "perimeters", 1.03).when_broken = core::Severity::kWarning;
    AsExported exported = joint.compare();
    EXPECT_FALSE(exported.joints[1].binding);
    EXPECT_NEAR(exported.joints[1].dead_band[0], by_hand(0.4, 1.03 * 1.03 * kParallelRate), 1e-9);
    EXPECT_NEAR(exported.worst_change(), 2e-4, 1e-6);
    joint.design.parts[1].arm_errors[0].arms_mm[7] = std::nan("");
    exported = joint.compare();
    EXPECT_NE(exported.joints[0].refusal.find("k_pe.stl"), std::string::npos) << exported.joints[0].refusal;
    EXPECT_TRUE(std::isnan(exported.joints[0].dead_band[0]));
    EXPECT_TRUE(std::isnan(exported.worst_change())) << "lost, not passed over";
}

/// Other programs' files, by the whole way through `make`.
class Programs : public fixtures::TempFolder {
protected:
    [[nodiscard]] nlohmann::json made(const std::string& formats, const fixtures::Changes& changes = {}) {
        auto text = fixtures::with_key(core::read_file(fixtures::shipped("measured_table")), "outputs.formats", formats);
        text = fixtures::with_keys(fixtures::with_key(text, "outputs.pair", "false"), changes);
        lay_tables();
        const batch::MakeResult result = batch::make(profile::read_profile(write("p.toml", text)), {.out = folder_ / "out"});
        EXPECT_TRUE(result.made);
        return nlohmann::json::parse(core::read_file(result.folder / "report.json"));
    }
};

TEST_F(Programs, OpenScadsStlCarriesTheLaw) {
    if (!core::on_path("openscad")) GTEST_SKIP() << "openscad is not installed";
    const auto joints = made("[\"scad_stl\"]", {{"tolerances.chordal_error_mm", "0.012"}})["as_exported"]["joints"];
    ASSERT_EQ(joints.size(), 2u);
    for (const auto& joint : joints) {
        EXPECT_EQ(joint["k_se"]["file"], "k_se_openscad.stl");
        EXPECT_LE(joint["k_pe"]["worst_arm_relative"], 1e-3);
    }
}

TEST_F(Programs, PrusaSlicersPerimetersAreWithinHalfALayer) {
    if (!exchange::can_slice()) GTEST_SKIP() << "prusa-slicer is not installed";
    const auto report = made("[\"sliced\"]");
    const auto& joint = report["as_exported"]["joints"].at(0);
    EXPECT_EQ(joint["reader"], "perimeters");
    EXPECT_EQ(joint["binding"], false);
    for (const char* part : {"k_se", "k_pe"}) EXPECT_GT(joint[part]["worst_arm_relative"], 1e-4) << "layers are seen";
    for (const auto& part : report["parts"]) EXPECT_EQ(part["read_back"].at(0)["passed"], true);
}

TEST_F(Programs, OnlyAPrintIsSliced) {
    try {
        (void)made("[\"sliced\"]", {{"process.kind", "\"mill\""}});
        ADD_FAILURE() << "not refused";
    } catch (const core::InvalidInput& error) {
        EXPECT_NE(error.field().find("outputs.formats"), std::string::npos) << error.field();
        EXPECT_NE(error.allowed().find("fdm"), std::string::npos);
    }
}

}  // namespace
}  // namespace fusee::pipeline
