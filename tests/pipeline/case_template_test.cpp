#include <cmath>

#include "fusee/core/error.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/rig.h"
#include "fusee/pipeline/simulate.h"
#include "pipeline/fixture.h"
#include "refused.h"

// From a profile to the empty gap case of its joint.
namespace fusee::pipeline {
namespace {

class TemplateOfProfile : public fixtures::TempFolder {
protected:
    [[nodiscard]] profile::Profile changed(const std::string& key, const std::string& value) const {
        return profile::read_profile(write("p.toml", fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), key, value)));
    }
    profile::Profile pnrvsa_ = profile::read_profile(fixtures::shipped("pnrvsa"));
};

TEST_F(TemplateOfProfile, TakesTheRigAsItIsDesigned) {
    const auto made = case_template(pnrvsa_);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->name, "pnrvsa");
    EXPECT_EQ(made->rig.capstan_radius, 0.03);
    EXPECT_EQ(made->rig.gear_load_friction, 0.28);
    EXPECT_EQ(made->rig.motor_inertia, 2e-3);
    EXPECT_EQ(made->rig.se_torsion_rate, 0.0183);
    EXPECT_EQ(made->rig.pe_compression_rate, 7460.0);
    EXPECT_EQ(made->torques.low, 0.85);
    EXPECT_EQ(made->torques.high, 1.5);
}

/// The cam that follows from the curve on a base spring without preload is the designed one: at each row above the stop the energy under
/// the curve is that of the preloaded base spring, 1/2 k (state)^2.
TEST_F(TemplateOfProfile, EnergyUnderTheCurvesIsThatOfThePreloadedSprings) {
    const auto design = resolve(pnrvsa_);
    ASSERT_TRUE(design);
    constexpr int kRows = 4000;  // the trapezoidal rule is off by some h^2
    const SpringsWithoutStops springs = springs_without_stops(*design->law(), pnrvsa_.k_se.spring, pnrvsa_.k_pe.spring, kRows);
    EXPECT_EQ(springs.rows.front().deflection, 0.0);
    EXPECT_EQ(springs.rows.front().se_torque, 0.0);
    EXPECT_EQ(springs.rows.front().pe_torque, 0.0);
    const spring::LawPoint start = design->law()->at_angle(0.0);
    double se = 0.5 * 0.0183 * 3.7 * 3.7, pe = 0.5 * 7460.0 * 0.0146 * 0.0146;  // at the stop
    const double length = springs.rest_deflection;
    EXPECT_NEAR(length, 2.0 * std::max(se / start.f_se, pe / start.f_pe), 1e-12);
    double below_se = 0.0, below_pe = 0.0;
    for (std::size_t i = 1; i < springs.rows.size(); ++i) {
        const auto &a = springs.rows[i - 1], &b = springs.rows[i];
        ASSERT_GT(b.deflection, a.deflection);
        ASSERT_GE(b.se_torque, a.se_torque);
        ASSERT_GE(b.pe_torque, a.pe_torque);
        const double step = b.deflection - a.deflection;
        const double se_step = 0.5 * (a.se_torque + b.se_torque) * step, pe_step = 0.5 * (a.pe_torque + b.pe_torque) * step;
        (b.deflection <= length * (1.0 + 1e-12) ? below_se : se) += se_step;
        (b.deflection <= length * (1.0 + 1e-12) ? below_pe : pe) += pe_step;
    }
    // 120 rows below the stop and torques ~ x^n there, n below 12: the trapezoidal rule is off by n (n + 1)/(12 * 120^2).
    EXPECT_NEAR(below_se, 0.5 * 0.0183 * 3.7 * 3.7, 1e-3 * below_se);
    EXPECT_NEAR(below_pe, 0.5 * 7460.0 * 0.0146 * 0.0146, 1e-3 * below_pe);
    const spring::LawPoint end = design->law()->at_angle(design->law()->angles().high);
    EXPECT_NEAR(se, 0.5 * 0.0183 * std::pow(pnrvsa_.k_se.spring.state(end.u_se), 2.0), 1e-6 * se);
    EXPECT_NEAR(pe, 0.5 * 7460.0 * std::pow(pnrvsa_.k_pe.spring.state(end.u_pe), 2.0), 1e-6 * pe);
    EXPECT_NEAR(springs.rows.back().se_torque, end.f_se, 1e-12);
}

TEST_F(TemplateOfProfile, IsACaseWhoseFirstEmptyCellIsNamed) {
    const auto made = case_template(pnrvsa_);
    ASSERT_TRUE(made);
    gap_case::write_case_template(*made, folder_ / "case");
    try {
        (void)gap_case::read_case(folder_ / "case");
        FAIL() << "a sheet without a measurement was taken";
    } catch (const core::InvalidInput& refused) {
        const std::string field = refused.field();
        EXPECT_NE(field.find("breakaway.csv:2:"), std::string::npos) << field;
        EXPECT_NE(field.find("load_torque_Nm"), std::string::npos) << field;
    }
    gap_case::Rows rows;
    rows.breakaway = gap_case::set_points(*made).breakaway;
    for (gap_case::BreakAway& row : rows.breakaway) row.load_torque = row.motor_torque * (row.backdrive ? 1.4 : 0.78);
    gap_case::Case files;
    files.files[gap_case::Experiment::kBreakAway] = {"breakaway.csv"};
    gap_case::write_rows(files, rows, folder_ / "case");
    const std::string toml = core::read_file(folder_ / "case" / "case.toml");
    write("case/case.toml", toml.substr(0, toml.find("[experiments]")) + "[experiments]\nbreakaway = \"breakaway.csv\"\n");
    const gap_case::Case read = gap_case::read_case(folder_ / "case");
    EXPECT_EQ(read.rows.size(), 96u);
    EXPECT_EQ(read.rig.joint_radius, pnrvsa_.rig.joint_radius);
    EXPECT_EQ(read.rig.springs.size(), 320u);
    EXPECT_TRUE(read.remarks.empty());
}

TEST_F(TemplateOfProfile, RefusesWhatACaseCannotHold) {
    const auto refused = [](const profile::Profile& profile) { return field_refused([&] { return case_template(profile); }); };
    EXPECT_NE(refused(changed("rig.gear_friction_constant_Nm", "0.01")).find("rig.gear_friction_constant_Nm"), std::string::npos);
    EXPECT_EQ(field_refused([&] { return case_template(pnrvsa_, {.springs_rows = 3}); }), "springs_rows");
    profile::Profile bare = pnrvsa_;
    bare.k_pe.spring.preload = 0.0;
    EXPECT_EQ(refused(bare), "k_pe.spring.preload_mm");
    bare.has_parts = false;
    EXPECT_EQ(refused(bare), "k_se.spring.rate_Nm_per_rad");
}

// One function says how hard the joint is pushed: at the bench as in the simulation. The template once asked for 0.5495 Nm at every
// co-contraction, where a full push is 0.8408 Nm at 0.85 Nm and more above it.
TEST_F(TemplateOfProfile, PushesAsHardAsTheSimulation) {
    const auto made = case_template(pnrvsa_);
    ASSERT_TRUE(made);
    const std::vector<gap_case::DeadBandRow> rows = gap_case::set_points(*made).dead_band;
    const auto simulated = simulate(pnrvsa_, {.levels = 2});
    ASSERT_TRUE(simulated);
    const auto same = [](const gap_case::DeadBandRow& row, const SimulatedLevel& level) {
        EXPECT_EQ(row.cocontraction, level.dead_band.tau);
        EXPECT_NEAR(row.push_torque, level.reading.push_torque, 5e-5);  // set points have four digits
        EXPECT_GE(row.push_torque, level.reading.full_push);
    };
    same(rows.front(), simulated->levels.front());
    same(rows.back(), simulated->levels.back());
    EXPECT_NEAR(rows.front().push_torque, 0.8828, 1e-4);
    gap_case::write_case_template(*made, folder_ / "case");
    const std::string sheets = core::read_file(folder_ / "case" / "BENCH.md");
    EXPECT_NE(sheets.find("The pushes are those of `fusee simulate`"), std::string::npos);
    EXPECT_NE(sheets.find("a push of at most 0.221 Nm does not"), std::string::npos) << sheets;
}

TEST_F(TemplateOfProfile, PushesAsTheProfileSays) {
    const auto made = case_template(changed("simulate.push_torque_Nm", "0.6"));
    ASSERT_TRUE(made);
    for (const gap_case::DeadBandRow& row : gap_case::set_points(*made).dead_band) EXPECT_EQ(row.push_torque, 0.6);
}

}  // namespace
}  // namespace fusee::pipeline
