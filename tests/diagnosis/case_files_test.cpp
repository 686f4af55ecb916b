#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "fusee/diagnosis/diagnose.h"
#include "long_form.h"
#include "predicted_gap.h"

// From the files of a case to the verdict, on excerpts of six labelled cases of another simulator and of two rigs of the plant
// (tests/diagnosis/cases): break-away of both gears, every sixth row of the spring pulls and, where drag is sought, two seconds of the
// log. Sizes are those that were built in.
namespace fusee::diagnosis {
namespace {

struct BuiltIn {
    const char *id, *side;
    double size;
};
struct LabelledCase {
    const char* folder;
    VerdictKind verdict;
    std::vector<BuiltIn> effects;
};
void PrintTo(const LabelledCase& c, std::ostream* out) { *out << c.folder; }

class CaseFiles : public testing::TestWithParam<LabelledCase> {};

TEST_P(CaseFiles, GiveTheEffectsThatWereBuiltIn) {
    const std::filesystem::path folder = std::filesystem::path(FUSEE_SOURCE_DIR) / "tests/diagnosis/cases" / GetParam().folder;
    const gap_case::Case gap_case = gap_case::read_case(folder);
    const Diagnosis found = diagnose(gap_case, {.jobs = 2, .progress = {}});
    EXPECT_EQ(found.verdict, GetParam().verdict) << diagnosis_json(found);
    ASSERT_EQ(found.effects.size(), GetParam().effects.size()) << diagnosis_json(found);
    for (const BuiltIn& built_in : GetParam().effects) {
        const auto at = std::find_if(found.effects.begin(), found.effects.end(), [&](const FoundEffect& f) {
            return f.cause == inference::Cause{built_in.id, built_in.side};
        });
        ASSERT_NE(at, found.effects.end()) << built_in.id;
        EXPECT_NEAR(at->parameter.value, built_in.size, 0.15 * std::abs(built_in.size)) << built_in.id;
    }
    // What the file says predicts what the rig did: read back, it leaves what the diagnosis states.
    const Diagnosis read = parse_diagnosis(diagnosis_json(found), "diagnosis.json");
    EXPECT_EQ(read.effects.size(), found.effects.size());
    EXPECT_EQ(predict(gap_case, read, gap_case.rows).spring_pull.size(), gap_case.rows.spring_pull.size());
    EXPECT_NEAR(fixtures::predicted_gap(gap_case, read), found.gap.after, 1e-6 * found.gap.after);
    EXPECT_LT(found.gap.heldout_after, 2.0);
    if (!found.effects.empty()) {
        EXPECT_LT(found.gap.heldout_after, 0.65 * found.gap.heldout_before);
    }
}

std::vector<LabelledCase> labelled_cases() {
    return fixtures::some_of<LabelledCase>(
        {{"as_designed", VerdictKind::kInconclusive, {}},
         {"gear_coulomb", VerdictKind::kIdentified, {{"gear.coulomb", "agonist", 0.0402}}},
         {"joint_viscous", VerdictKind::kIdentified, {{"joint.viscous", "none", 0.0228}}},
         {"se_rate", VerdictKind::kIdentified, {{"se.rate", "both", 0.1576}}},
         {"pe_hysteresis_and_se_rate", VerdictKind::kIdentified, {{"pe.hysteresis", "both", 0.1408}, {"se.rate", "antagonist", -0.0804}}},
         {"unequal_sides", VerdictKind::kIdentified, {{"gear.coulomb", "antagonist", 0.0961}, {"gear.coulomb", "agonist", 0.0370}}},
         {"joint_viscous_and_se_radius",
          VerdictKind::kIdentified,
          {{"joint.viscous", "none", 0.0391}, {"se.radius", "antagonist", -0.00174}}},
         {"three_effects",
          VerdictKind::kIdentified,
          {{"gear.coulomb", "antagonist", 0.0326}, {"joint.viscous", "none", 0.0423}, {"se.radius", "agonist", -0.00148}}}},
        6);
}
INSTANTIATE_TEST_SUITE_P(All, CaseFiles, testing::ValuesIn(labelled_cases()));

}  // namespace
}  // namespace fusee::diagnosis
