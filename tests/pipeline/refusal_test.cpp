#include <algorithm>
#include <cmath>
#include <ostream>

#include "fusee/batch/batch.h"
#include "pipeline/fixture.h"

// Law: an impossible design names what binds, with measured and allowed value; the change that it suggests, made, takes that finding away.
namespace fusee::pipeline {
namespace {

namespace fs = std::filesystem;

using fixtures::Changes;

/// A change that makes a shipped profile impossible.
struct RefusedDesign {
    const char* name;
    const char* profile;
    Changes changes;
    const char* rule;
    std::vector<const char*> suggested;  ///< keys whose suggested number has to clear the finding, each by itself ("a+b": both together)
};
void PrintTo(const RefusedDesign& c, std::ostream* out) { *out << c.name; }

const RefusedDesign kRefusedDesigns[] = {
    {"transmission_of_1", "pnrvsa", {{"law.start_torque_Nm", "0.2"}}, "law.transmission", {"law.start_torque_Nm", "law.c_Nm"}},
    {"negative_transmission", "pnrvsa", {{"law.c_Nm", "-0.001"}, {"law.u_Nm", "0.02"}}, "law.transmission", {"law.c_Nm"}},
    {"negative_stiffness", "first_prototype", {{"law.parallel_Nm", "[0.0, 0.25, -0.09]"}}, "law.stiffness", {"law.end_torque_Nm"}},
    {"law_out_of_reach", "measured_table", {{"law.end_torque_Nm", "50.0"}}, "law.range", {"law.end_torque_Nm"}},
    {"lead_in_too_long", "pnrvsa", {{"law.lead_in_deg", "300"}}, "law.lead_in", {"law.lead_in_deg"}},
    {"convexity_at_the_end", "pnrvsa", {{"law.end_torque_Nm", "3.2"}}, "cam.convexity", {"law.end_torque_Nm"}},
    {"end_far_off", "pnrvsa", {{"law.end_torque_Nm", "10000.0"}}, "cam.arm", {"law.end_torque_Nm"}},
    {"convexity_at_the_start", "measured_table", {{"k_se.spring.preload_rad", "0.1"}}, "cam.convexity", {"k_se.spring.preload_rad"}},
    {"unloaded_torsion_spring", "pnrvsa", {{"k_se.spring.preload_rad", "0.0"}}, "cam.arm", {"k_se.spring.preload_rad"}},
    {"unloaded_compression_spring", "pnrvsa", {{"k_pe.spring.preload_mm", "0.0"}}, "cam.arm", {"k_pe.spring.preload_mm"}},
    {"hair_thin_spring", "pnrvsa", {{"k_pe.spring.rate_N_per_m", "1e-9"}}, "cam.arm", {"k_pe.spring.rate_N_per_m"}},
    {"rigid_spring", "pnrvsa", {{"k_pe.spring.rate_N_per_m", "1e9"}}, "cam.arm", {"k_pe.spring.rate_N_per_m"}},
    {"guide_too_near", "measured_table", {{"k_se.guide.distance_mm", "5.0"}}, "cam.guide", {"k_se.guide.distance_mm"}},
    {"more_than_a_turn", "pnrvsa", {{"k_se.spring.rate_Nm_per_rad", "4e-3"}}, "cam.wrap", {"law.end_torque_Nm"}},
    {"larger_than_the_printer", "pnrvsa", {{"process.build_mm", "[15.0, 15.0, 15.0]"}}, "process.build_volume", {"process.build_mm"}},
    {"past_solid",
     "pnrvsa",
     {{"k_pe.spring.max_travel_mm", "20.0"}},
     "spring.travel",
     {"k_pe.spring.preload_mm"}},  // the rate alone has no convex cam: such a change is not suggested
    {"past_the_winding", "pnrvsa", {{"k_se.spring.max_angle_rad", "5.0"}}, "spring.torsion_angle", {"k_se.spring.rate_Nm_per_rad"}},
    {"cable_as_thick_as_its_bend", "pnrvsa", {{"cable.diameter_mm", "8.0"}}, "solid.floor", {"cable.diameter_mm"}},
    {"bore_too_wide", "measured_table", {{"k_se.hub.bore_mm", "40.0"}}, "solid.bore", {"k_se.hub.bore_mm"}},
    {"contact_far_out", "pnrvsa", {{"k_pe.spring.preload_mm", "0.3"}}, "cam.arm", {"k_pe.spring.preload_mm"}},
    {"coarse_mesh", "pnrvsa", {{"tolerances.chordal_error_mm", "1.0"}}, "readback.arm", {"tolerances.chordal_error_mm"}},
};

class Impossible : public fixtures::TempFolder, public testing::WithParamInterface<RefusedDesign> {
protected:
    batch::MakeResult try_to_make(const Changes& changes) const {
        std::string text = core::read_file(fixtures::shipped(GetParam().profile));
        const Changes one_format = {{"outputs.formats", "[\"stl\"]"}};  // a refusal is the same in every format; the cure is made in one
        for (const Changes& some : {one_format, GetParam().changes, changes}) text = fixtures::with_keys(text, some);
        lay_tables();
        return batch::make(profile::read_profile(write("t.toml", text)), {.out = folder_ / "out"});
    }
};
INSTANTIATE_TEST_SUITE_P(Pipeline, Impossible, testing::ValuesIn(kRefusedDesigns),
                         [](const auto& one) { return std::string(one.param.name); });

const core::Finding* find(const core::Findings& findings, const std::string& rule) {
    const auto found = std::find_if(findings.begin(), findings.end(),
                                    [&](const core::Finding& f) { return f.rule == rule && f.severity == core::Severity::kError; });
    return found == findings.end() ? nullptr : &*found;
}

/// What stands behind "key = " in a suggestion: a number, or an array.
std::string suggested(const core::Finding& finding, const std::string& key) {
    const std::size_t at = finding.suggestion.text().find(key + " = ");
    if (at == std::string::npos) return "";
    const std::size_t begin = at + key.size() + 3;
    const bool array = finding.suggestion.text()[begin] == '[';
    const std::size_t end =
        array ? finding.suggestion.text().find(']', begin) + 1 : finding.suggestion.text().find_first_not_of("0123456789.e+-", begin);
    return finding.suggestion.text().substr(begin, end == std::string::npos ? end : end - begin);
}

TEST_P(Impossible, NamesTheLimitAndItsCureAndLeavesNothingBehind) {
    fs::create_directories(folder_ / "out");
    const batch::MakeResult refused = try_to_make({});
    ASSERT_FALSE(refused.made);
    EXPECT_TRUE(fs::is_empty(folder_ / "out"));
    const core::Finding* finding = find(refused.findings, GetParam().rule);
    ASSERT_NE(finding, nullptr) << (refused.findings.empty() ? "" : core::to_line(refused.findings.front()));
    EXPECT_TRUE(std::isfinite(finding->measured)) << core::to_line(*finding);
    EXPECT_TRUE(std::isfinite(finding->allowed)) << core::to_line(*finding);
    EXPECT_FALSE(finding->where.empty());
    EXPECT_FALSE(finding->source.empty());
    for (const std::string key : GetParam().suggested) {
        Changes changes;
        for (std::size_t at = 0; at < key.size();) {
            const std::size_t end = std::min(key.find('+', at), key.size());
            const std::string one = key.substr(at, end - at), value = suggested(*finding, one);
            ASSERT_NE(value, "") << one << " in " << finding->suggestion.text();
            changes.emplace_back(one, value);
            at = end + 1;
        }
        const batch::MakeResult cured = try_to_make(changes);
        const core::Finding* still = find(cured.findings, GetParam().rule);
        EXPECT_TRUE(still == nullptr || still->where.substr(0, 4) != finding->where.substr(0, 4))
            << changes.front().first << " = " << changes.front().second << ": " << core::to_line(*still);
    }
}

}  // namespace
}  // namespace fusee::pipeline
