#include <gtest/gtest.h>

#include "fusee/core/change.h"
#include "fusee/pipeline/check.h"
#include "fusee/profile/profile.h"
#include "pipeline/fixture.h"

// A suggestion is applied and judged before it is shown.
namespace fusee::pipeline {
namespace {

const profile::Profile& pnrvsa_as_shipped() {
    static const profile::Profile profile = profile::read_profile(fixtures::shipped("pnrvsa"));
    return profile;
}

/// The suggestion of a warning against K_SE, as it is left.
std::string suggestion_left(const core::Suggestion& suggestion, const char* rule, const profile::Profile& profile) {
    core::Finding f;
    f.rule = rule, f.where = "k_se", f.severity = core::Severity::kWarning, f.suggestion = suggestion;
    core::Findings all{f};
    judge_suggestions(all, profile);
    return all.front().suggestion.text();
}

// K_SE of pnrvsa is less than 5 mm high.
TEST(JudgedSuggestions, ASlotDeeperThanItsPartIsLeftOut) {
    const core::Suggestion deep = core::change("k_se.features.leg_slot_depth_mm", "4.83");
    core::Suggestion either = deep;
    either.or_else(core::change("k_se.features.leg_slot_radius_mm", "5.5").noted(" (a wider coil)"));
    EXPECT_EQ(suggestion_left(either, "assembly.leg_pressure", pnrvsa_as_shipped()),
              "k_se.features.leg_slot_radius_mm = 5.5 (a wider coil)");
    EXPECT_EQ(suggestion_left(deep, "assembly.leg_pressure", pnrvsa_as_shipped()),
              "no single change of the profile (k_se.features.leg_slot_depth_mm = 4.83 breaks structure.slot_floor k_se)");
}

TEST(JudgedSuggestions, AChangeThatDoesNotHelpOrIsNotAllowedIsLeftOut) {
    profile::Profile narrow = pnrvsa_as_shipped();
    narrow.k_se.solid.features.leg_slot_width = 1.0e-3;  // for a wire of 1.1 mm
    const auto left = [&](const char* mm) {
        return suggestion_left(core::change("k_se.features.leg_slot_width_mm", mm), "assembly.leg_width", narrow);
    };
    EXPECT_EQ(left("1.2"), "k_se.features.leg_slot_width_mm = 1.2");
    EXPECT_NE(left("0.9").find("does not help"), std::string::npos) << left("0.9");
    EXPECT_NE(left("-1").find("is not allowed"), std::string::npos) << left("-1");
    EXPECT_EQ(suggestion_left("a wider slot", "assembly.leg_width", narrow), "a wider slot") << "words stay";
}

}  // namespace
}  // namespace fusee::pipeline
