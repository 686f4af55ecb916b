#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/batch/batch.h"
#include "fusee/cam/arm.h"
#include "fusee/exchange/part_file.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/rig.h"
#include "fusee/search/redesign.h"
#include "pipeline/fixture.h"

// profiles/examples/elastic_cable.toml as a user makes it: springs, cams and cables that stretch have the law together.
namespace fusee::pipeline {
namespace {

class Stretched : public fixtures::TempFolder {
protected:
    [[nodiscard]] static std::string example() {
        return fixtures::with_keys(core::read_file(fixtures::shipped("examples/elastic_cable")),
                                   {{"outputs.formats", "[\"stl\"]"}, {"outputs.pair", "false"}, {"outputs.plate", "false"}});
    }
    [[nodiscard]] profile::Profile read(const std::string& text) const { return profile::read_profile(write("elastic.toml", text)); }
    [[nodiscard]] profile::Profile changed(const std::string& key, const std::string& value) const {
        return read(fixtures::with_key(example(), key, value));
    }
};

/// Torque over the capstan's angle from PART.json alone: trapezoids, Hooke's law and the stretch that its rows state.
struct Read {
    std::vector<double> theta, torque;
};
Read recomputed(const exchange::PartFile& part, double capstan) {
    Read law;
    double drawn = 0.0;
    for (std::size_t i = 0; i < part.target.size(); ++i) {
        const exchange::TargetRow& row = part.target[i];
        if (i > 0) drawn += 5e-4 * (row.arm_mm + part.target[i - 1].arm_mm) * (row.angle_rad - part.target[i - 1].angle_rad);
        const double arm = 1e-3 * row.arm_mm, stretch = 1e-3 * row.stretch_mm;
        if (part.part == "k_se") {
            law.theta.push_back((drawn + stretch) / capstan);
            law.torque.push_back(capstan * part.spring_rate * (part.spring_preload + row.angle_rad) / arm);
        } else {
            law.theta.push_back(row.angle_rad);
            law.torque.push_back(part.spring_rate * (part.spring_preload + drawn - stretch) * arm);
        }
    }
    return law;
}

// The files' joint has the nominal dead-band, PART.json gives the law back, and both reports state the same stretch. 400 rows:
// the trapezoids miss less than 0.01 %, the chords of the STL 0.03 % (docs/theory/read_back.md).
TEST_F(Stretched, IsMadeAndCarriesItsLaw) {
    const profile::Profile profile = read(example());
    const batch::MakeResult result = batch::make(profile, {.out = folder_ / "out"});
    for (const core::Finding& f : result.findings) EXPECT_NE(f.severity, core::Severity::kError) << core::to_line(f);
    ASSERT_TRUE(result.made);
    EXPECT_LT(result.file_errors.dead_band, 5e-4);
    const auto law = resolve(profile)->law();
    const auto report = nlohmann::json::parse(core::read_file(result.folder / "report.json"));
    const auto simulation = nlohmann::json::parse(core::read_file(result.folder / "simulation.json"));
    for (const int i : {0, 1}) {
        const std::string name = i == 0 ? "k_se" : "k_pe";
        const Read read = recomputed(exchange::read_part_file(result.folder / (name + ".json")), 0.03);
        for (std::size_t row = 0; row < read.theta.size(); ++row) {
            const spring::LawPoint p = law->at_angle(read.theta[row]);
            EXPECT_NEAR(read.torque[row], i == 0 ? p.f_se : p.f_pe, 1e-4 * read.torque[row]) << name << " " << row;
        }
        const auto& stated = report["parts"][i]["cam"]["stretch"];
        const auto& simulated = simulation["stretch"][i];
        EXPECT_EQ(simulated["part"], name);
        for (const char* key : {"load_Nm", "length_mm", "capstan_rad", "share"})
            EXPECT_NEAR(stated[key].get<double>(), simulated[key].get<double>(), 1e-9 * simulated[key].get<double>()) << key;
    }
    const double k_g = 7460.0 * 0.15 / 25000.0;
    EXPECT_NEAR(report["parts"][1]["cam"]["stretch"]["share"].get<double>(), k_g / (1.0 + k_g), 1e-12);
    EXPECT_NE(core::read_file(result.folder / "report.html").find("\"stretch\":{"), std::string::npos);
    EXPECT_NE(core::read_file(result.folder / "simulation.html").find("Cable elongation at"), std::string::npos);
}

// A cam that was cut as if its cable were rigid is off by about the stretch's share of the law.
TEST_F(Stretched, ARigidCablesCamIsOff) {
    const profile::Profile elastic = read(example()), rigid = changed("k_pe.cable_length_mm", "0");
    const auto design = resolve(rigid);
    const spring::SpringLawPtr law = design->law();
    const auto cam = design_cam(cam::PartKind::kParallel, *design);
    ASSERT_TRUE(cam);
    std::vector<cam::FoundArm> arms;
    for (const cam::Contact& c : cam->working) arms.push_back({c.arm.angle, c.arm.arm});
    const auto built = cam::spring_of_arms(cam::PartKind::kParallel, arms, elastic.k_pe.spring, 0.03, elastic.k_pe.allowance);
    // F = F_0 + k_e y in the place of F_0 + k y.
    const double end = law->angles().high, first = 7460.0 * 0.0146, last = cam->working.back().arm.tension;
    EXPECT_NEAR(built->force(end) / law->at_angle(end).f_pe, (first + (last - first) / (1.0 + 7460.0 * 0.15 / 25000.0)) / last, 1e-6);
}

TEST_F(Stretched, ACableShorterThanItsWrapIsRefused) {
    ResolvedDesign design = *resolve(read(example()));
    design.profile = changed("k_pe.cable_length_mm", "40");
    const auto part = design_part(cam::PartKind::kParallel, design);
    ASSERT_FALSE(part);
    bool named = false;
    for (const core::Finding& f : part.refusal())
        named |= f.rule == "cable.length" && f.severity == core::Severity::kError &&
                 f.suggestion.text().find("k_pe.cable_length_mm = ") != std::string::npos && f.allowed > 40.0;
    EXPECT_TRUE(named);
}

// The loop closed on a rig whose cables stretch: what a diagnosis finds comes on top, and the new cams carry the law.
TEST_F(Stretched, RedesignKeepsItsCables) {
    const std::string text = example();
    const profile::Profile profile = read(text);
    gap_case::Case gap_case;
    gap_case.name = "monday";
    gap_case.sha256 = std::string(64, 'a');
    gap_case.rig = case_template(profile)->rig;
    diagnosis::Diagnosis found;
    found.verdict = diagnosis::VerdictKind::kIdentified;
    for (const auto& [id, value, unit] : {std::tuple{"cable.stretch", 50.0, "Nm/rad"}, {"pe.rate", 0.08, "1"}, {"se.rate", -0.05, "1"}})
        found.effects.push_back({{id, "both"}, 0.99, {value, {0.95 * value, 1.05 * value}, unit}, {}});
    const search::redesign::Redesign result =
        search::redesign::plan_redesign(profile, text, gap_case, found, {.file = folder_ / "redesign.toml", .levels = 3});
    ASSERT_EQ(result.profiles.size(), 1u);
    const profile::Profile fresh = profile::parse_profile(result.profiles[0].toml, result.profiles[0].file);
    EXPECT_NEAR(fresh.k_se.allowance.behind_spool(0.03), 0.02 + 0.2 / 25000.0 / 9e-4, 1e-9);
    EXPECT_EQ(fresh.k_pe.allowance.cable_compliance, profile.k_pe.allowance.cable_compliance);
    EXPECT_GT(result.torque_error_old, 0.02);
    EXPECT_LT(result.torque_error_new, 1e-5);  // six digits in the profile
}

}  // namespace
}  // namespace fusee::pipeline
