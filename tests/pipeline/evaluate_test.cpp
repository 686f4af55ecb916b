#include "fusee/pipeline/evaluate.h"

#include <algorithm>
#include <array>
#include <set>

#include "fusee/pipeline/check.h"
#include "fusee/pipeline/make.h"
#include "pipeline/fixture.h"

// The one chain: a deeper evaluation repeats what a shallow one says, says how far it came, and every command that judges a design says
// the same of it.
namespace fusee::pipeline {
namespace {

class Evaluate : public fixtures::TempFolder {
protected:
    [[nodiscard]] profile::Profile changed(const char* name, const fixtures::Changes& changes) const {
        lay_tables();
        return profile::read_profile(write("changed.toml", fixtures::with_keys(core::read_file(fixtures::shipped(name)), changes)));
    }
    [[nodiscard]] static std::multiset<std::string> lines_of(const core::Findings& findings) {
        std::multiset<std::string> lines;
        for (const core::Finding& f : findings) lines.insert(core::to_line(f));
        return lines;
    }
    [[nodiscard]] static const core::Finding* find(const core::Findings& findings, const std::string& rule, const std::string& where) {
        const auto found = std::find_if(findings.begin(), findings.end(),
                                        [&](const core::Finding& f) { return f.rule == rule && f.where.starts_with(where); });
        return found == findings.end() ? nullptr : &*found;
    }
};

TEST_F(Evaluate, EachDepthRepeatsTheOneBefore) {
    const profile::Profile profile = profile::read_profile(fixtures::shipped("pnrvsa"));
    const Evaluation law = evaluate(profile, Depth::kLaw), cam = evaluate(profile, Depth::kCam),
                     outline = evaluate(profile, Depth::kOutline), solid = evaluate(profile, Depth::kSolid);
    ASSERT_TRUE(law.design);
    EXPECT_TRUE(law.parts.empty());
    EXPECT_EQ(lines_of(law.findings), lines_of(resolve(profile)->findings));
    ASSERT_EQ(cam.parts.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(cam.parts[i].reached, Depth::kCam);
        EXPECT_TRUE(cam.parts[i].cam && cam.parts[i].findings.empty());
        EXPECT_EQ(outline.parts[i].reached, Depth::kOutline);
        EXPECT_TRUE(outline.parts[i].body && outline.parts[i].body->mesh.triangles.empty());
        EXPECT_EQ(solid.parts[i].reached, Depth::kSolid);
        EXPECT_FALSE(solid.parts[i].body->mesh.triangles.empty());
        const auto shallow = lines_of(outline.parts[i].findings), deep = lines_of(solid.parts[i].findings);
        EXPECT_TRUE(std::includes(deep.begin(), deep.end(), shallow.begin(), shallow.end()));
    }
    EXPECT_NE(std::find_if(solid.findings.begin(), solid.findings.end(), [](const auto& f) { return f.rule.starts_with("joint."); }),
              solid.findings.end());
}

TEST_F(Evaluate, APartTakenDeeperIsThePartAtThatDepth) {
    const ResolvedDesign design = *resolve(profile::read_profile(fixtures::shipped("pnrvsa")));
    EvaluatedPart part = evaluate_part(cam::PartKind::kParallel, design, Depth::kOutline);
    deepen(part, design, Depth::kSolid);
    const EvaluatedPart at_once = evaluate_part(cam::PartKind::kParallel, design, Depth::kSolid);
    EXPECT_EQ(lines_of(part.findings), lines_of(at_once.findings));
    EXPECT_EQ(part.body->mesh.points_mm, at_once.body->mesh.points_mm);
}

TEST_F(Evaluate, ARefusalSaysHowFarItCame) {
    const Evaluation no_law = evaluate(changed("pnrvsa", {{"law.c_Nm", "0.6"}}), Depth::kOutline);
    EXPECT_FALSE(no_law.design);
    EXPECT_TRUE(no_law.parts.empty());
    EXPECT_FALSE(no_law.passed());
    const Evaluation no_cam = evaluate(changed("pnrvsa", {{"k_pe.spring.rate_N_per_m", "1e-9"}}), Depth::kOutline);
    EXPECT_EQ(no_cam.parts[0].reached, Depth::kOutline);
    EXPECT_EQ(no_cam.parts[1].reached, Depth::kLaw);
    EXPECT_FALSE(no_cam.parts[1].cam);
    const Evaluation no_body =
        evaluate(changed("pnrvsa", {{"k_se.features.anchor_hole_mm", "30"}}), Depth::kOutline, std::array{cam::PartKind::kSeries});
    ASSERT_EQ(no_body.parts.size(), 1u);
    EXPECT_EQ(no_body.parts[0].reached, Depth::kCam);
    EXPECT_TRUE(no_body.parts[0].cam && core::any_error(no_body.parts[0].findings));
}

// A cable that is too short for its cam was known to the make of the solid alone.
TEST_F(Evaluate, TheOutlineKnowsAShortCable) {
    const Evaluation seen = evaluate(changed("examples/elastic_cable", {{"k_pe.cable_length_mm", "40"}}), Depth::kOutline);
    const core::Findings all = seen.all();
    const core::Finding* cable = find(all, "cable.length", "k_pe.cable_length_mm");
    ASSERT_NE(cable, nullptr);
    EXPECT_EQ(cable->severity, core::Severity::kError);
}

// Length and rating that a profile leaves out follow from wire, coils and turns: `check` took the profile as written and judged less.
TEST_F(Evaluate, CheckSaysWhatMakeSays) {
    const profile::Profile profile = changed("pnrvsa", {{"outputs.formats", "[\"stl\"]"},
                                                        {"k_pe.spring.max_travel_mm", "0"},
                                                        {"k_pe.spring.max_force_N", "0"},
                                                        {"outputs.pair", "false"},
                                                        {"outputs.plate", "false"}});
    const core::Findings checked = check(profile, std::array{profile.process.kind}).processes.front().all();
    const Evaluation made = evaluate(profile, Depth::kFiles);
    ASSERT_TRUE(made.passed());
    core::Findings without_files = made.all();
    std::erase_if(without_files, [](const core::Finding& f) { return f.rule.starts_with("readback.") || f.rule == "cam.certificate"; });
    judge_suggestions(without_files, profile);  // as check and make do before they print
    EXPECT_EQ(lines_of(checked), lines_of(without_files));
    const core::Finding* travel = find(checked, "spring.travel", "k_pe");
    ASSERT_NE(travel, nullptr);
    EXPECT_NE(travel->severity, core::Severity::kNotJudged);
}

}  // namespace
}  // namespace fusee::pipeline
