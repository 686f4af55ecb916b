#include <set>

#include "fusee/cam/arm.h"
#include "fusee/checks/check.h"
#include "fusee/pipeline/design.h"
#include "pipeline/fixture.h"

// Every rule can be reached: some profile that a person may write makes it measure.
namespace fusee::pipeline {
namespace {

using fixtures::Changes;

/// What a bought spring's data sheet says, and the cable's and the material's.
const Changes kDataSheets = {{"cable.max_pressure_MPa", "60"},     {"k_se.spring.wire_mm", "1.0"},
                             {"k_se.spring.coil_mm", "10.8"},      {"k_se.spring.active_coils", "12"},
                             {"k_se.spring.free_length_mm", "30"}, {"k_se.spring.tensile_strength_MPa", "2000"},
                             {"k_se.spring.max_angle_rad", "20"},  {"k_se.spring.max_torque_Nm", "1"},
                             {"k_se.spring.hand", "\"left\""},     {"k_se.spring.rod_mm", "6"},
                             {"k_se.spring.cycles", "1e5"},        {"k_pe.spring.wire_mm", "2.0"},
                             {"k_pe.spring.coil_mm", "16"},        {"k_pe.spring.active_coils", "8"},
                             {"k_pe.spring.free_length_mm", "70"}, {"k_pe.spring.tensile_strength_MPa", "2000"},
                             {"k_pe.hub.lock", "\"set_screw\""},   {"k_pe.hub.screw_mm", "3"},
                             {"k_pe.guide.kind", "\"point\""},     {"k_pe.guide.distance_mm", "150"}};
const Changes kHelix = {{"k_pe.path.kind", "\"helix\""},
                        {"k_pe.path.pitch_mm", "4"},
                        {"k_pe.path.margin_deg", "170"},
                        {"k_se.hub.lock", "\"d_flat\""},
                        {"k_pe.guide.kind", "\"parallel\""}};
Changes by(const char* process) { return {{"process.kind", std::string("\"") + process + '"'}}; }

using ReachTest = fixtures::TempFolder;

/// The rules that measure something on one of both parts. @param solids meshes too
void reached_by(const profile::Profile& p, bool solids, std::set<std::string>& ids) {
    const auto design = resolve(p);
    ASSERT_TRUE(design);
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const profile::PartSpec& spec = kind == cam::PartKind::kSeries ? p.k_se : p.k_pe;
        const auto cam = design_cam(kind, *design);
        ASSERT_TRUE(cam) << core::to_line(cam.refusal().front());
        const auto part = solids ? solid::build_part(*cam, spec.solid) : solid::outline_part(*cam, spec.solid);
        ASSERT_TRUE(part) << core::to_line(part.refusal().front());
        for (const core::Finding& f : checks::check({*part, spec.spring, p.cable, p.process, p.limits})) ids.insert(f.rule);
    }
}

TEST_F(ReachTest, EveryRuleMeasuresInSomeProfile) {
    const std::string shipped = core::read_file(fixtures::shipped("pnrvsa"));
    std::set<std::string> ids;
    for (const Changes& changes : {Changes{}, kDataSheets, kHelix, by("sla"), by("sls"), by("mill"), by("mill4"), by("edm"), by("laser")})
        reached_by(profile::read_profile(write("p.toml", fixtures::with_keys(shipped, changes))), changes.empty(), ids);
    reached_by(profile::read_profile(std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles/examples/roller_follower.toml"), false, ids);
    for (const checks::Rule& rule : checks::rules()) EXPECT_TRUE(ids.count(rule.id)) << rule.id;
}

TEST_F(ReachTest, AnOverrideDecidesWhetherADesignIsMade) {
    const std::string strict = core::read_file(fixtures::shipped("pnrvsa")) +
                               "\n[[limits]]\nrule = \"cable.bend_ratio\"\nrequired = 7\nreason = \"a stiff cable\"\n";
    const profile::Profile p = profile::read_profile(write("p.toml", strict));
    const auto refused = design_part(cam::PartKind::kParallel, *resolve(p));
    ASSERT_FALSE(refused);
    for (const core::Finding& f : refused.refusal()) {
        if (f.severity != core::Severity::kError) continue;
        EXPECT_EQ(f.rule, "cable.bend_ratio");
        EXPECT_EQ(f.allowed, 7.0);
        ASSERT_EQ(f.overridden.size(), 1u);
        EXPECT_EQ(f.overridden[0].normal, 4.0) << "of fibre";
    }
}

}  // namespace
}  // namespace fusee::pipeline
