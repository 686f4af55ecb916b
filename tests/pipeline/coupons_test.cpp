#include "fusee/pipeline/coupons.h"

#include <algorithm>
#include <cmath>

#include "fusee/batch/batch.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/formats/format.h"
#include "fusee/pipeline/design.h"
#include "fusee/readback/readback.h"
#include "fusee/solid/validity.h"
#include "pipeline/fixture.h"
#include "refused.h"

namespace fusee::pipeline {
namespace {

namespace fs = std::filesystem;

class CouponsTest : public fixtures::TempFolder {
protected:
    /// pnrvsa with changes; meshes only, coarse, and without the antagonist's mirror images, which nothing here looks at.
    profile::Profile pnrvsa(const fixtures::Changes& changes = {}) const {
        fixtures::Changes all{
            {"outputs.formats", "[\"stl\", \"3mf\"]"}, {"outputs.pair", "false"}, {"tolerances.chordal_error_mm", "0.003"}};
        all.insert(all.end(), changes.begin(), changes.end());
        toml_ = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")), all);
        return profile::parse_profile(toml_, folder_ / "pnrvsa.toml");
    }
    mutable std::string toml_;
};

const fixtures::Changes kCompensated{{"compensation.shrink_x_percent", "0.4"},
                                     {"compensation.shrink_y_percent", "0.6"},
                                     {"compensation.shrink_z_percent", "-0.2"},
                                     {"compensation.bore_offset_mm", "0.12"}};

TEST_F(CouponsTest, AFolderWithSolidsSheetAndPage) {
    const profile::Profile profile = pnrvsa();
    const Coupons made = make_coupons(profile, folder_ / "out");
    ASSERT_TRUE(made.made);
    EXPECT_EQ(made.folder, folder_ / "out" / "pnrvsa-coupons");
    const auto files = fixtures::contents(made.folder);
    std::vector<std::string> names;
    for (const auto& [name, bytes] : files) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"COUPON.csv", "README.md", "bores_and_lengths.3mf", "bores_and_lengths.stl", "disc.3mf",
                                               "disc.json", "disc.stl", "groove_ladder.3mf", "groove_ladder.stl"}));
    for (const char* name : {"bores_and_lengths", "groove_ladder", "disc"}) {
        const solid::Mesh mesh = exchange::read_stl_assimp(made.folder / (std::string(name) + ".stl"));
        EXPECT_TRUE(solid::validate(mesh).good()) << name;
        EXPECT_EQ(exchange::read_3mf(made.folder / (std::string(name) + ".3mf")).triangles.size(), mesh.triangles.size());
    }
    EXPECT_EQ(std::count_if(made.findings.begin(), made.findings.end(), [](const auto& f) { return f.rule == "readback.arm"; }), 3)
        << "the disc's arm read back from STL, twice, and 3MF";
    EXPECT_EQ(make_coupons(pnrvsa(kCompensated), folder_ / "other").files[0].entry.triangles, made.files[0].entry.triangles)
        << "coupons are nominal";
}

TEST_F(CouponsTest, AMachineTooSmallIsTheBindingLimit) {
    const Coupons made = make_coupons(pnrvsa({{"process.build_mm", "[50.0, 200.0, 200.0]"}}), folder_ / "out");
    EXPECT_FALSE(made.made);
    ASSERT_TRUE(core::any_error(made.findings));
    EXPECT_EQ(made.findings.front().rule, "coupon.build_volume");
    EXPECT_EQ(made.findings.front().allowed, 50.0);
    EXPECT_GT(made.findings.front().measured, 50.0);
    EXPECT_FALSE(fs::exists(folder_ / "out" / "pnrvsa-coupons"));
}

TEST_F(CouponsTest, CompensatedFilesComeOutNominal) {
    const batch::MakeResult plain = batch::make(pnrvsa(), {.out = folder_ / "plain"});
    const batch::MakeResult result = batch::make(pnrvsa(kCompensated), {.out = folder_ / "out"});
    ASSERT_TRUE(plain.made && result.made);
    for (const std::string part : {"k_se", "k_pe"}) {
        const exchange::PartFile file = exchange::read_part_file(result.folder / (part + "_compensated.json"));
        ASSERT_TRUE(file.compensated);
        EXPECT_EQ(file.compensated->shrink_percent, (std::array<double, 3>{0.4, 0.6, -0.2}));
        EXPECT_TRUE(file.provenance.starts_with("compensated, not nominal")) << file.provenance;
        const solid::Mesh nominal = exchange::read_stl_assimp(result.folder / (part + ".stl"));
        const solid::Mesh compensated = exchange::read_stl_assimp(result.folder / (part + "_compensated.stl"));
        const solid::Box small = solid::bounding_box(nominal), large = solid::bounding_box(compensated);
        const double shrink[] = {0.004, 0.006, -0.002};
        for (std::size_t axis = 0; axis < 3; ++axis)  // once, not twice; single precision of 50 mm
            EXPECT_NEAR((large.high_mm[axis] - large.low_mm[axis]) * (1.0 - shrink[axis]), small.high_mm[axis] - small.low_mm[axis], 1e-5);
        EXPECT_EQ(nominal.points_mm, exchange::read_stl_assimp(plain.folder / (part + ".stl")).points_mm)
            << "nominal files stay as they are";
        EXPECT_NEAR(readback::bore_mm(result.folder / (part + "_compensated.stl"), file), 6.2, 1e-4) << "6 mm and a clearance of 0.2";
        EXPECT_NE(core::read_file(result.folder / (part + "_compensated.stl")).find("compensated, not nominal"), std::string::npos);

        exchange::PartFile wrong = file;  // what a file compensated by other figures than stated would be
        wrong.compensated->shrink_percent = {0.0, 0.0, 0.0};
        for (const readback::ArmError& error : formats::read_back(result.folder, wrong)) EXPECT_FALSE(error.passed()) << error.file;
        for (const readback::ArmError& error : formats::read_back(result.folder, file)) EXPECT_TRUE(error.passed()) << error.file;
        for (const exchange::FileEntry& entry : exchange::read_part_file(result.folder / (part + ".json")).files)
            EXPECT_EQ(entry.name.find("compensated"), std::string::npos) << "PART.json names the files that carry the law as they are";
    }
}

TEST_F(CouponsTest, ACompensatedBoreThatBreaksAWallIsFound) {
    const auto k_pe = [&](const char* offset) {
        const profile::Profile profile = pnrvsa({{"k_pe.hub.boss_mm", "11.2"}, {"compensation.bore_offset_mm", offset}});
        return design_part(cam::PartKind::kParallel, *resolve(profile));
    };
    // A boss of 11.2 mm round a bore of 6.2 mm with a key of 1 mm leaves 1.5 mm; 2 mm more bore leave 0.5 mm.
    ASSERT_TRUE(k_pe("0.0")) << "the nominal wall is thick enough";
    EXPECT_TRUE(k_pe("0.2"));
    const auto broken = k_pe("2.0");
    ASSERT_FALSE(broken);
    const auto found = std::find_if(broken.refusal().begin(), broken.refusal().end(), [](const core::Finding& f) {
        return f.severity == core::Severity::kError && f.rule == "shaft.hub_wall" &&
               f.where.find("in the compensated file") != std::string::npos;
    });
    ASSERT_NE(found, broken.refusal().end());
    EXPECT_FALSE(found->suggestion.empty());
}

TEST_F(CouponsTest, TheCablesAxisShortensEveryArmByItself) {
    const profile::Profile plain = pnrvsa(), shorter = pnrvsa({{"compensation.cable_axis_mm", "0.05"}});
    EXPECT_TRUE(shorter.compensation.none()) << "nothing to compensate in the files";
    const ResolvedDesign design = *resolve(plain);
    ResolvedDesign with_shorter = design;
    with_shorter.profile = shorter;
    for (const auto kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const auto a = design_cam(kind, design), b = design_cam(kind, with_shorter);
        ASSERT_TRUE(a && b);
        ASSERT_EQ(a->working.size(), b->working.size());
        for (std::size_t i = 0; i < a->working.size(); ++i) EXPECT_NEAR(a->working[i].arm.arm - b->working[i].arm.arm, 0.05e-3, 1e-12);
    }
}

/// A filled sheet, in the units of its rows: shrinkage 0.5 % along x and y, bores 0.1 mm under, the axis 0.1 mm out.
coupon::Sheet measured() {
    coupon::Sheet sheet;
    sheet.cable_diameter_mm = 0.8;
    sheet.disc_floor_mm = 15.0;
    for (const double length : {16.0, 66.0, 16.0, 66.0})
        for (const coupon::Item item : {coupon::Item::kLengthX, coupon::Item::kLengthY})
            sheet.rows.push_back({item, length, 0.995 * length});
    for (const double bore : {6.0, 6.2, 6.4}) sheet.rows.push_back({coupon::Item::kBore, bore, 0.995 * bore - 0.1});
    for (const double turns : {0.0, 1.0, 2.0, 3.0})
        sheet.rows.push_back({coupon::Item::kDiscPull, turns, 2.0 * core::kPi * (0.995 * 15.0 + 0.5) * turns});
    return sheet;
}

TEST_F(CouponsTest, ACalibratedProfileHoldsTheFiguresAndNothingElseChanges) {
    const profile::Profile profile = pnrvsa();
    const coupon::Calibration found = coupon::calibrate(measured(), present_of(profile), "c.csv");
    const std::string text = calibrated_profile(profile, toml_, measured(), found, folder_ / "new.toml");
    const profile::Profile fresh = profile::parse_profile(text, folder_ / "new.toml");
    EXPECT_EQ(fresh.name, "pnrvsa-calibrated");
    EXPECT_NEAR(fresh.compensation.shrink[0], 0.005, 1e-8);
    EXPECT_NEAR(fresh.compensation.shrink[1], 0.005, 1e-8);
    EXPECT_EQ(fresh.compensation.shrink[2], 0.0) << "not measured";
    EXPECT_NEAR(fresh.compensation.bore_offset, 0.1e-3, 1e-9);
    EXPECT_NEAR(fresh.k_se.allowance.cable_axis, 0.1e-3, 1e-9);
    EXPECT_EQ(fresh.k_pe.allowance.cable_axis, fresh.k_se.allowance.cable_axis);
    EXPECT_NE(text.find("# shrink_x_percent was 0"), std::string::npos) << "each change says why";
    EXPECT_NE(text.find("# paper, section VI and figure 8"), std::string::npos) << "the writer's comments stay";
    // The same sheet again changes nothing: figures that it agrees with stay.
    const coupon::Calibration again = coupon::calibrate(measured(), present_of(fresh), "c.csv");
    for (const coupon::Figure& figure : again.figures) EXPECT_FALSE(figure.changes()) << figure.id;
    EXPECT_EQ(calibrated_profile(fresh, text, measured(), again, folder_ / "new.toml"), text);
    std::string second = text;  // nor does it where the profile was calibrated more than once
    second.replace(second.find("pnrvsa-calibrated"), 17, "pnrvsa-calibrated-2");
    const profile::Profile twice = profile::parse_profile(second, folder_ / "new.toml");
    EXPECT_EQ(calibrated_profile(twice, second, measured(), again, folder_ / "new.toml"), second);
}

/// K_PE with a contour that is 0.1 mm too large everywhere.
coupon::InspectionSheet inspected() {
    coupon::InspectionSheet sheet{"k_pe", {}};
    for (int i = 0; i < 12; ++i) {
        const double psi = 0.15 * i, c = std::cos(psi), s = std::sin(psi);
        coupon::InspectionRow row{coupon::Inspected::kContour, i + 1, 8e-3 * c - 5e-3 * psi * s, 8e-3 * s + 5e-3 * psi * c, 0.0, psi, 8e-3};
        row.low = -0.3e-3, row.high = 0.3e-3, row.deviation = 0.1e-3;
        sheet.rows.push_back(row);
    }
    return sheet;
}

TEST_F(CouponsTest, AnInspectedProfileHoldsTheOffsetAndShortensTheArms) {
    const profile::Profile profile = pnrvsa();
    const coupon::Calibration found = coupon::inspect_contour(inspected(), present_of(profile));
    const std::string text = inspected_profile(profile, toml_, inspected(), found, folder_ / "new.toml");
    const profile::Profile fresh = profile::parse_profile(text, folder_ / "new.toml");
    EXPECT_NEAR(fresh.k_pe.allowance.contour, 0.1e-3, 1e-9);
    EXPECT_EQ(fresh.k_se.allowance.contour, 0.0);
    EXPECT_NE(text.find("# k_pe_contour_mm was 0: inspection, 12 rows"), std::string::npos);
    const auto as_was = design_cam(cam::PartKind::kParallel, *resolve(profile)),
               now = design_cam(cam::PartKind::kParallel, *resolve(fresh));
    ASSERT_TRUE(as_was && now);
    for (std::size_t i = 0; i < now->working.size(); ++i) EXPECT_NEAR(as_was->working[i].arm.arm - now->working[i].arm.arm, 0.1e-3, 1e-9);
    const coupon::Calibration again = coupon::inspect_contour(inspected(), present_of(fresh));
    EXPECT_FALSE(again.find("contour_offset")->changes()) << "the next part's deviations are from its own file";
}

TEST_F(CouponsTest, AnOffsetIsNotCountedTwice) {
    const auto refused = [&](const fixtures::Changes& changes) {
        const profile::Profile profile = pnrvsa(changes);
        return field_refused([&] {
            return inspected_profile(profile, toml_, inspected(), coupon::inspect_contour(inspected(), present_of(profile)),
                                     folder_ / "n.toml");
        });
    };
    EXPECT_NE(refused({{"k_pe.radius_allowance_mm", "0.1"}}).find("k_pe.radius_allowance_mm"), std::string::npos);
    EXPECT_EQ(refused({{"k_se.radius_allowance_mm", "0.1"}}), "accepted") << "of the other part";
    EXPECT_NE(refused({{"compensation.cable_axis_mm", "0.1"}}).find("compensation.cable_axis_mm"), std::string::npos);
}

TEST_F(CouponsTest, WhatWouldBeCountedTwiceIsRefused) {
    const auto refused = [&](const fixtures::Changes& changes) {
        const profile::Profile profile = pnrvsa(changes);
        return field_refused([&] {
            return calibrated_profile(profile, toml_, measured(), coupon::calibrate(measured(), present_of(profile), "c.csv"),
                                      folder_ / "n.toml");
        });
    };
    EXPECT_NE(refused({{"k_pe.radius_allowance_mm", "0.1"}}).find("k_pe.radius_allowance_mm"), std::string::npos);
    EXPECT_NE(refused({{"compensation.k_se_contour_mm", "0.1"}}).find("compensation.k_se_contour_mm"), std::string::npos);
    EXPECT_NE(refused({{"cable.diameter_mm", "1.0"}}).find("cable.diameter_mm"), std::string::npos) << "coupons of another cable";
}

}  // namespace
}  // namespace fusee::pipeline
