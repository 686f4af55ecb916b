#include "fusee/core/change.h"

#include <gtest/gtest.h>

// Known: the sentences that findings suggest, and what they ask to be changed.
namespace fusee::core {
namespace {

std::string shown(const std::vector<Changes>& alternatives) {
    std::string text;
    for (const Changes& changes : alternatives) {
        text += text.empty() ? "" : " | ";
        for (std::size_t i = 0; i < changes.size(); ++i) text += (i > 0 ? " & " : "") + changes[i].key + "=" + changes[i].value;
    }
    return text;
}

struct Row {
    const char *suggestion, *expected;
};

class SuggestedChanges : public testing::TestWithParam<Row> {};

TEST_P(SuggestedChanges, AreThoseOfTheSentence) { EXPECT_EQ(shown(suggested_changes(GetParam().suggestion)), GetParam().expected); }

INSTANTIATE_TEST_SUITE_P(
    Core, SuggestedChanges,
    testing::Values(Row{"", ""}, Row{"a guide rod of 12 mm, or a chamfer there", ""},
                    Row{"tolerances.chordal_error_mm = 0.002", "tolerances.chordal_error_mm=0.002"},
                    Row{"k_pe.hub.bore_mm = 5.2, or k_pe.spring.rate_N_per_m = 9e+03 with k_pe.spring.preload_mm = 4.1 (every arm x 0.9)",
                        "k_pe.hub.bore_mm=5.2 | k_pe.spring.rate_N_per_m=9e+03 & k_pe.spring.preload_mm=4.1"},
                    Row{"law.start_torque_Nm = 0.27 (or law.c_Nm = -0.5)", "law.start_torque_Nm=0.27 | law.c_Nm=-0.5"},
                    Row{"k_se.path.kind = \"helix\", or law.end_torque_Nm = 1.9", "k_se.path.kind=\"helix\" | law.end_torque_Nm=1.9"},
                    Row{"process.build_mm = [1, 2.5, 3], or k_pe.path.pitch_mm = 2.2",
                        "process.build_mm=[1, 2.5, 3] | k_pe.path.pitch_mm=2.2"},
                    Row{"a free cable of 90 mm there (k_se.guide.distance_mm = 120), or half height (k_se.guide.z_mm = 0)",
                        "k_se.guide.distance_mm=120 | k_se.guide.z_mm=0"},
                    Row{"cable.diameter_mm = 0.5, or rho 2 mm there: k_se.spring.rate_Nm_per_rad = 0.02 with k_se.spring.preload_rad = 3",
                        "cable.diameter_mm=0.5 | k_se.spring.rate_Nm_per_rad=0.02 & k_se.spring.preload_rad=3"},
                    Row{"rig.least_torque_Nm = 0.9, or law.lead_in_deg larger", "rig.least_torque_Nm=0.9"},
                    Row{"k_pe.guide.z_mm = 3.2: the groove then rises by 4 mm per turn", "k_pe.guide.z_mm=3.2"}));

}  // namespace
}  // namespace fusee::core
