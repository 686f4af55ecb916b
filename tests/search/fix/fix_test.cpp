#include "fusee/search/fix.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/report/search.h"
#include "fusee/spring/coil.h"
#include "pipeline/fixture.h"

// Law: what makes a shipped profile impossible is taken away by a change of the keys that are wrong, and of no other; without any one of
// the changes it stays impossible; what cannot be cured says what binds.
namespace fusee::search::fix {
namespace {

namespace fs = std::filesystem;

using fixtures::Changes;

struct Case {
    const char* name;
    const char* profile;
    Changes spoiled;
    std::set<std::string> cured_by;  ///< keys; empty: it cannot be
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

constexpr int kOnlyLook = 3;  // profiles judged: enough to see that nothing is wrong

/// The shipped joint without the data of its springs, which join every change of a rate to coils and rating, and with an anchor that the
/// working arc does not reach, away from the slot.
const fixtures::Changes kBare{{"k_se.path.margin_deg", "20.0535"}, {"k_se.features.leg_slot_angle_deg", "180"},
                              {"k_se.spring.wire_mm", "0"},        {"k_se.spring.coil_mm", "0"},
                              {"k_se.spring.active_coils", "0"},   {"k_se.spring.max_angle_rad", "0"},
                              {"k_se.spring.max_torque_Nm", "0"},  {"k_pe.spring.wire_mm", "0"},
                              {"k_pe.spring.coil_mm", "0"},        {"k_pe.spring.active_coils", "0"},
                              {"k_pe.spring.max_travel_mm", "50"}, {"k_pe.spring.max_force_N", "200"}};

const Case kCases[] = {
    {"shallow_groove", "pnrvsa", {{"groove.depth_ratio", "0.3"}}, {"groove.depth_ratio", "k_se.features.leg_slot_depth_mm"}},
    {"steep_throat", "pnrvsa", {{"groove.throat_deg", "40"}}, {"groove.throat_deg"}},
    {"wide_anchor", "pnrvsa", {{"k_se.features.anchor_hole_mm", "30"}}, {"k_se.features.anchor_hole_mm"}},
    {"thin_anchor", "pnrvsa", {{"k_se.features.anchor_hole_mm", "0.5"}}, {"k_se.features.anchor_hole_mm"}},
    {"deep_slot", "pnrvsa", {{"k_se.features.leg_slot_depth_mm", "9"}}, {"k_se.features.leg_slot_depth_mm"}},
    {"thick_cable",
     "pnrvsa",
     {{"cable.diameter_mm", "1.6"}, {"cable.breaking_load_N", "3600"}},
     {"cable.diameter_mm", "cable.breaking_load_N"}},
    {"guide_within_the_spool", "measured_table", {{"k_se.guide.distance_mm", "5"}}, {"k_se.guide.distance_mm"}},
    {"guide_near_the_helix", "first_prototype", {{"k_pe.guide.distance_mm", "10"}}, {"k_pe.guide.distance_mm"}},
    {"flat_idle_arc", "pnrvsa", {{"k_se.path.min_idle_radius_mm", "60"}}, {"k_se.path.min_idle_radius_mm"}},
    {"thin_web", "pnrvsa", {{"k_pe.hub.web_mm", "0.1"}}, {"k_pe.hub.web_mm"}},
    {"weak_cable", "pnrvsa", {{"cable.breaking_load_N", "150"}}, {"cable.breaking_load_N"}},
    {"stiff_cable", "pnrvsa", {{"cable.min_bend_ratio", "10"}}, {"cable.diameter_mm", "cable.breaking_load_N", "k_pe.spring.rate_N_per_m"}},
    {"weak_spring", "pnrvsa", {{"k_pe.spring.max_force_N", "100"}}, {"k_pe.spring.rate_N_per_m"}},
    {"past_solid", "pnrvsa", {{"k_pe.spring.max_travel_mm", "20"}}, {"k_pe.spring.preload_mm"}},
    {"unloaded_torsion_spring", "pnrvsa", {{"k_se.spring.preload_rad", "0"}}, {"k_se.spring.preload_rad"}},
    {"little_loaded_spool", "measured_table", {{"k_se.spring.preload_rad", "0.1"}}, {"k_se.spring.preload_rad"}},
    {"hair_thin_spring", "pnrvsa", {{"k_pe.spring.rate_N_per_m", "1e-9"}}, {"k_pe.spring.rate_N_per_m"}},
    {"rigid_spring", "pnrvsa", {{"k_pe.spring.rate_N_per_m", "1e9"}}, {"k_pe.spring.rate_N_per_m"}},
    {"more_than_a_turn", "pnrvsa", {{"k_se.spring.rate_Nm_per_rad", "4e-3"}}, {"k_se.spring.rate_Nm_per_rad"}},
    {"long_lead_in",
     "pnrvsa",
     {{"law.lead_in_deg", "300"}, {"k_se.guide.kind", "\"parallel\""}, {"k_se.guide.distance_mm", "10000"}},
     {"law.lead_in_deg"}},
    {"transmission_of_1", "pnrvsa", {{"law.start_torque_Nm", "0.2"}}, {"law.start_torque_Nm"}},
    {"end_beyond_convexity", "pnrvsa", {{"law.end_torque_Nm", "3.2"}}, {"law.end_torque_Nm"}},
    {"end_far_off", "pnrvsa", {{"law.end_torque_Nm", "10000"}}, {"law.end_torque_Nm"}},
    {"end_beyond_the_table", "measured_table", {{"law.end_torque_Nm", "50"}}, {"law.end_torque_Nm"}},
    {"four_at_once",
     "pnrvsa",
     {{"groove.throat_deg", "40"},
      {"k_se.features.anchor_hole_mm", "0.5"},
      {"k_se.features.leg_slot_depth_mm", "9"},
      {"k_pe.spring.max_travel_mm", "20"}},
     {"groove.throat_deg", "k_se.features.anchor_hole_mm", "k_se.features.leg_slot_depth_mm", "k_pe.spring.preload_mm"}},
    {"one_spring_of_a_thin_rim", "single/gravity_balance", {{"cam.roller.rim_width_mm", "3"}}, {"cam.roller.rim_width_mm"}},
    {"one_spring_of_a_steep_throat", "single/constant_torque", {{"groove.throat_deg", "40"}}, {"groove.throat_deg"}},
    {"walls_of_20_mm", "pnrvsa", {{"process.min_wall_mm", "20"}}, {}},
    {"bends_of_200", "pnrvsa", {{"cable.min_bend_ratio", "200"}}, {}},
};

class Fixing : public fixtures::TempFolder, public testing::WithParamInterface<Case> {
protected:
    [[nodiscard]] static std::string spoiled(const Case& c) {
        const std::string text = core::read_file(fixtures::shipped(c.profile));
        return fixtures::with_keys(std::string(c.profile) == "pnrvsa" ? fixtures::with_keys(text, kBare) : text, c.spoiled);
    }
    /// Judged as drawings alone: what makes the difference shows there, in milliseconds.
    [[nodiscard]] Fix fix_drawing(const std::string& toml, int most_judged) const {
        lay_tables();
        const auto drawn = [](const profile::Profile&) { return core::Findings{}; };
        return find_fix(profile::parse_profile(toml, folder_ / "t.toml"), toml,
                        {.file = folder_ / "fixed.toml", .most_judged = most_judged, .make = drawn});
    }
};

/// Lines of the profile with every key, as a set.
std::set<std::string> all_keys(const std::string& toml, const fs::path& file) {
    const std::string text = profile::to_toml(profile::parse_profile(toml, file));
    std::set<std::string> lines;
    std::string table;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (line.starts_with('[')) table = line;
        lines.insert(table + line);
        at = end + 1;
    }
    return lines;
}

TEST_P(Fixing, ChangesWhatIsWrongAndNothingElse) {
    const std::string toml = spoiled(GetParam());
    const bool curable = !GetParam().cured_by.empty();
    const Fix fixed = fix_drawing(toml, curable ? 1000 : 12);  // more does not help
    if (!curable) {
        EXPECT_EQ(fixed.end, Fix::End::kCannot) << report::fix_text(fixed);
        EXPECT_TRUE(fixed.toml.empty());
        ASSERT_FALSE(fixed.left.empty());
        for (const core::Finding& f : fixed.left) EXPECT_EQ(f.severity, core::Severity::kError) << core::to_line(f);
        return;
    }
    ASSERT_EQ(fixed.end, fixed.lost.empty() ? Fix::End::kFixed : Fix::End::kShortened) << report::fix_text(fixed);
    EXPECT_EQ(report::fix_text(fixed).find(": fixed by ") != std::string::npos, fixed.lost.empty()) << report::fix_text(fixed);
    std::set<std::string> keys;
    for (const MadeChange& change : fixed.changes) keys.insert(change.key);
    EXPECT_EQ(keys, GetParam().cured_by) << report::fix_text(fixed);
    // Of the profile with every key so many lines are others as keys were changed, and the name.
    const std::set<std::string> before = all_keys(toml, folder_ / "t.toml"), after = all_keys(fixed.toml, folder_ / "fixed.toml");
    std::vector<std::string> others;
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(others));
    EXPECT_EQ(others.size(), keys.size() + 1) << testing::PrintToString(others);
    EXPECT_TRUE(std::any_of(others.begin(), others.end(), [](const std::string& line) {
        return line.starts_with("name = ") && line.ends_with("-fixed\"");
    })) << testing::PrintToString(others);
    const bool law = std::any_of(keys.begin(), keys.end(), [](const std::string& key) { return key.starts_with("law."); });
    if (law) return;
    EXPECT_EQ(fixed.band_before, fixed.band_after) << "the law and its dead-band stay where only bodies were wrong";
    EXPECT_TRUE(fixed.lost.empty());
}

/// Of one change alone there is nothing to leave out.
std::vector<Case> cured_by_several() {
    std::vector<Case> cases;
    std::copy_if(std::begin(kCases), std::end(kCases), std::back_inserter(cases), [](const Case& c) { return c.cured_by.size() > 1; });
    return cases;
}
class FixingBySeveral : public Fixing {};

/// Each change alone taken back, the profile is impossible again.
TEST_P(FixingBySeveral, NoChangeCanBeLeftOut) {
    const Fix fixed = fix_drawing(spoiled(GetParam()), 1000);
    for (const MadeChange& change : fixed.changes) {
        if (!change.follows.empty()) continue;  // it goes with the other one
        const Fix again = fix_drawing(fixtures::with_key(fixed.toml, change.key, change.was), kOnlyLook);
        EXPECT_NE(again.end, Fix::End::kNothingToDo) << change.key;
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Fixing, testing::ValuesIn(kCases), [](const auto& instance) { return instance.param.name; });
INSTANTIATE_TEST_SUITE_P(Shipped, FixingBySeveral, testing::ValuesIn(cured_by_several()),
                         [](const auto& instance) { return instance.param.name; });

class FixTest : public fixtures::TempFolder {
protected:
    /// Judged as drawings alone, unless the options make them.
    [[nodiscard]] Fix drawn(const std::string& toml, FixOptions options) const {
        lay_tables();
        options.file = folder_ / "fixed.toml";
        if (!options.make) options.make = [](const profile::Profile&) { return core::Findings{}; };
        return find_fix(profile::parse_profile(toml, folder_ / "t.toml"), toml, options);
    }
};

/// Coarse meshes are found when files are read back: everything is made.
TEST_F(FixTest, IsMadeAndReadBack) {
    const std::string toml =
        fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")),
                            {{"tolerances.chordal_error_mm", "1.0"}, {"outputs.formats", "[\"stl\"]"}, {"outputs.pair", "false"}});
    std::vector<std::string> steps;
    const Fix fixed = find_fix(profile::parse_profile(toml, folder_ / "t.toml"), toml,
                               {.file = folder_ / "fixed.toml", .progress = [&](const std::string& step) { steps.push_back(step); }});
    ASSERT_EQ(fixed.end, Fix::End::kFixed) << report::fix_text(fixed);
    ASSERT_EQ(fixed.changes.size(), 1u);
    EXPECT_EQ(fixed.changes.front().key, "tolerances.chordal_error_mm");
    EXPECT_EQ(fixed.changes.front().because.rule, "readback.arm");
    EXPECT_EQ(fixed.made, 2);
    EXPECT_FALSE(steps.empty());
    EXPECT_FALSE(fs::exists(folder_ / "fixed.toml")) << "writing is the caller's";
    const Fix again = find_fix(profile::parse_profile(fixed.toml, folder_ / "fixed.toml"), fixed.toml, {.file = folder_ / "again.toml"});
    EXPECT_EQ(again.end, Fix::End::kNothingToDo) << report::fix_text(again);
    EXPECT_TRUE(again.toml.empty());
}

/// The steps back towards the old rate are judged by their solids.
TEST_F(FixTest, WritesFilesOfTheSearchAndOfTheEndAlone) {
    const std::string toml = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")), {{"process.kind", "\"mill4\""},
                                                                                                {"material.kind", "\"steel\""},
                                                                                                {"groove.throat_deg", "45"},
                                                                                                {"k_se.features.leg_slot_angle_deg", "180"},
                                                                                                {"k_pe.spring.rate_N_per_m", "9420"},
                                                                                                {"k_pe.spring.max_force_N", "223"}});
    int made = 0;
    const auto make = [&made](const profile::Profile&) {
        ++made;
        return core::Findings{};
    };
    const Fix fixed = drawn(toml, {.file = {}, .make = make});
    ASSERT_EQ(fixed.end, Fix::End::kFixed) << report::fix_text(fixed);
    EXPECT_EQ(made, 2) << report::fix_text(fixed);
    EXPECT_EQ(fixed.made, made);
}

/// Only the make of every file knew it, once for each draft.
TEST_F(FixTest, SeesAShortCableBeforeAnythingIsMade) {
    const std::string toml = fixtures::with_key(core::read_file(fixtures::shipped("examples/elastic_cable")), "k_pe.cable_length_mm", "40");
    const Fix fixed = drawn(toml, {.file = {}, .most_judged = 60});
    EXPECT_EQ(fixed.end, Fix::End::kCannot) << report::fix_text(fixed);
    EXPECT_EQ(fixed.made, 0);
    EXPECT_TRUE(std::any_of(fixed.left.begin(), fixed.left.end(), [](const core::Finding& f) { return f.rule == "cable.length"; }))
        << report::fix_text(fixed);
}

/// pnrvsa with a steel cable of 3 mm, as in the shop, on a spool that a fibre cable of 0.8 mm was made for.
std::string steel_cable(const std::string& breaking_load) {
    return fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa_co_design")),
                               {{"cable.diameter_mm", "3.0"}, {"cable.construction", "\"7x7\""}, {"cable.breaking_load_N", breaking_load}});
}

const MadeChange* change_of(const Fix& fix, const std::string& key) {
    const auto found = std::find_if(fix.changes.begin(), fix.changes.end(), [&key](const auto& change) { return change.key == key; });
    return found == fix.changes.end() ? nullptr : &*found;
}

/// Differences of both springs' rates from those of their coils, relative.
double inconsistency(const std::string& toml, const fs::path& file) {
    const profile::Profile p = profile::parse_profile(toml, file);
    const auto off = [](const spring::BaseSpring& s) { return std::abs(spring::rate_of_coils(s) / s.rate - 1.0); };
    return std::max(off(p.k_se.spring), off(p.k_pe.spring));
}

/// Turns were scaled in proportion to the rate: a start whose turns did not fit stayed wrong on every step of a scan.
TEST_F(FixTest, WindsTheSpringOfAnotherRate) {
    for (const fixtures::Changes& spoiled : {fixtures::Changes{{"k_pe.spring.active_coils", "9"}},
                                             {{"k_pe.spring.rate_N_per_m", "30000"}, {"k_pe.spring.active_coils", "9"}},
                                             {{"k_se.spring.rate_Nm_per_rad", "0.004"}, {"k_se.spring.active_coils", "40"}}}) {
        const std::string toml = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")), spoiled);
        EXPECT_GT(inconsistency(toml, folder_ / "t.toml"), 0.3);
        const Fix fixed = drawn(toml, {});
        ASSERT_NE(fixed.end, Fix::End::kCannot) << report::fix_text(fixed);
        EXPECT_LT(inconsistency(fixed.toml, folder_ / "fixed.toml"), 1e-3) << report::fix_text(fixed);  // 3e-4: the shipped ones
    }
}

/// A spring whose turns are not stated has those of its rate on every step.
TEST_F(FixTest, LeavesTurnsThatAreNotStatedToTheRate) {
    std::string toml = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")), {{"k_se.spring.rate_Nm_per_rad", "0.004"}});
    toml.erase(toml.find("active_coils = 25.75"), 21);
    const Fix fixed = drawn(toml, {});
    ASSERT_EQ(fixed.end, Fix::End::kShortened) << report::fix_text(fixed);
    EXPECT_EQ(change_of(fixed, "k_se.spring.active_coils"), nullptr);
    ASSERT_EQ(fixed.lost.size(), 1U);
    EXPECT_EQ(fixed.lost.front().key, "law.start_torque_Nm");
    EXPECT_NE(report::fix_text(fixed).find("not over its whole law"), std::string::npos);
    EXPECT_LT(inconsistency(fixed.toml, folder_ / "fixed.toml"), 1e-3);  // 3e-4: K_PE's stated ones
}

bool says(const std::vector<std::string>& lines, const std::string& words) {
    return std::any_of(lines.begin(), lines.end(), [&words](const std::string& line) { return line.find(words) != std::string::npos; });
}

/// Was fixed into a wire of 0.36 mm.
TEST_F(FixTest, DoesNotWeakenACableWhoseStrengthIsNotStated) {
    const Fix fixed = drawn(steel_cable("0"), {.file = {}, .most_judged = 60});
    EXPECT_EQ(fixed.end, Fix::End::kCannot) << report::fix_text(fixed);
    EXPECT_EQ(change_of(fixed, "cable.diameter_mm"), nullptr);
    EXPECT_TRUE(says(fixed.unchanged, "cable.diameter_mm: its breaking load is not stated (cable.breaking_load_N)"))
        << report::fix_text(fixed);
}

/// 3 mm that break at 6 kN are 0.3 mm that break at 60 N: too little. It kept 6 kN.
TEST_F(FixTest, AThinnerCableKeepsItsStrengthPerArea) {
    const Fix fixed = drawn(steel_cable("6000"), {.file = {}, .most_judged = 60});
    EXPECT_EQ(fixed.end, Fix::End::kCannot) << report::fix_text(fixed);
    EXPECT_EQ(fixed.ended, "the search ended when 60 profiles had been judged (--most)");
    EXPECT_NE(report::fix_text(fixed).find("not every combination was tried: " + fixed.ended), std::string::npos);
    EXPECT_TRUE(says(fixed.unchanged, "cable.breaking_load_N: the cable was made thinner")) << report::fix_text(fixed);
    // Where the thinner cable holds, its breaking load follows it.
    const Fix thick = drawn(fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")),
                                                {{"cable.diameter_mm", "1.6"}, {"cable.breaking_load_N", "2700"}}),
                            {});
    ASSERT_EQ(thick.end, Fix::End::kFixed) << report::fix_text(thick);
    const MadeChange *diameter = change_of(thick, "cable.diameter_mm"), *load = change_of(thick, "cable.breaking_load_N");
    ASSERT_NE(diameter, nullptr);
    ASSERT_NE(load, nullptr);
    EXPECT_EQ(load->follows, "cable.diameter_mm");
    const double ratio = std::stod(diameter->value) / 1.6;
    EXPECT_NEAR(std::stod(load->value), 2700.0 * ratio * ratio, 1.0);
    EXPECT_LE(std::stod(load->value), 2700.0 * ratio * ratio);
}

/// It was 28.2 mm.
TEST_F(FixTest, AShaftStaysAStandardOne) {
    const std::string toml =
        fixtures::with_keys(core::read_file(fixtures::shipped("first_prototype")), {{"k_se.hub.bore_mm", "29"},
                                                                                    {"k_se.features.anchor_hole_mm", "0"},
                                                                                    {"k_se.features.leg_slot_width_mm", "0"},
                                                                                    {"k_se.hub.lock", "\"plain\""}});
    const Fix fixed = drawn(toml, {});
    ASSERT_EQ(fixed.changes.size(), 1u) << report::fix_text(fixed);
    EXPECT_EQ(fixed.changes.front().key, "k_se.hub.bore_mm");
    EXPECT_EQ(fixed.changes.front().value, "28");
    EXPECT_EQ(fixed.changes.front().asks_for, "another shaft");
    const Fix kept = drawn(toml, {.file = {}, .keep = {"k_se.hub"}});
    EXPECT_EQ(change_of(kept, "k_se.hub.bore_mm"), nullptr) << report::fix_text(kept);
    EXPECT_TRUE(says(kept.unchanged, "k_se.hub.bore_mm: it is kept (--keep)")) << report::fix_text(kept);
}

TEST_F(FixTest, KeepsOnlyWhatIsAKey) {
    try {
        (void)drawn(core::read_file(fixtures::shipped("pnrvsa")), {.file = {}, .keep = {"k_se.hub.bore"}});
        FAIL() << "accepted";
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.field(), "--keep");
        EXPECT_NE(e.allowed().find("k_se.hub.bore_mm"), std::string::npos) << e.what();
    }
}

/// Without these keys the search is beaten: it says which limits stand against each other, with both figures.
TEST_F(FixTest, NamesLimitsThatStandAgainstEachOther) {
    const Fix fixed = drawn(steel_cable("6000"), {.file = {}, .keep = {"cable"}, .most_judged = 200});
    ASSERT_EQ(fixed.end, Fix::End::kCannot) << report::fix_text(fixed);
    ASSERT_FALSE(fixed.conflicts.empty()) << report::fix_text(fixed);
    const Conflict& conflict = fixed.conflicts.front();
    EXPECT_NE(conflict.one.rule, conflict.other.rule);
    EXPECT_NE(conflict.change.was, conflict.change.value);
    const std::string text = report::fix_text(fixed);
    for (const std::string& word :
         {conflict.one.rule, conflict.other.rule, conflict.change.key + " = " + conflict.change.value, std::string("breaks")})
        EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

/// What was not judged is counted, as `make` counts it.
TEST_F(FixTest, CountsTheRulesThatWereNotJudged) {
    const Fix fixed = drawn(core::read_file(fixtures::shipped("pnrvsa")),
                            {.file = {}, .make = [](const profile::Profile&) {
                                 return core::Findings{core::not_judged("spring.stress", "stress of the wire", "k_se.spring.wire_mm")};
                             }});
    EXPECT_EQ(fixed.end, Fix::End::kNothingToDo);
    EXPECT_EQ(fixed.not_judged, 1u);
    EXPECT_NE(report::fix_text(fixed).find("1 rule not judged"), std::string::npos) << report::fix_text(fixed);
}

/// Another rate is a spring of the catalogue that the profile names, with all its data.
TEST_F(FixTest, TakesSpringsFromTheCatalogue) {
    core::write_file(folder_ / "springs.csv",
                     "kind,name,rate,wire_mm,coil_mm,active_coils,free_length_mm,max_deflection,max_load,tensile_strength_MPa\n"
                     "torsion,t,0.0183,1,12,14.66,0,60,3,2000\ncompression,c1,3000,2,20,6.79,80,60,300,1900\n"
                     "compression,c2,9000,2.5,20,5.53,80,60,600,1900\n");
    const std::string toml = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")),
                                                 {{"co_design.catalogue", "\"springs.csv\""}, {"k_pe.spring.max_force_N", "100"}});
    const Fix fixed = drawn(toml, {.file = {}, .most_judged = 200});
    const MadeChange* rate = change_of(fixed, "k_pe.spring.rate_N_per_m");
    ASSERT_NE(rate, nullptr) << report::fix_text(fixed);
    EXPECT_TRUE(rate->value == "3000" || rate->value == "9000") << rate->value;
    const MadeChange* wire = change_of(fixed, "k_pe.spring.wire_mm");
    ASSERT_NE(wire, nullptr) << report::fix_text(fixed);
    EXPECT_EQ(wire->value, rate->value == "3000" ? "2" : "2.5");
    EXPECT_EQ(wire->follows, "k_pe.spring.rate_N_per_m");
}

/// The loss is what no cam carries: a law that reaches 1 % farther is impossible.
TEST_F(FixTest, LosesNoMoreTorqueThanItMust) {
    const std::string toml = fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "law.end_torque_Nm", "3.2");
    const FixOptions options{.file = folder_ / "fixed.toml", .make = [](const profile::Profile&) { return core::Findings{}; }};
    const Fix fixed = find_fix(profile::parse_profile(toml, folder_ / "t.toml"), toml, options);
    ASSERT_EQ(fixed.lost.size(), 1u) << report::fix_text(fixed);
    const LostTorque& lost = fixed.lost.front();
    EXPECT_EQ(lost.key, "law.end_torque_Nm");
    EXPECT_EQ(lost.from, 3.2);
    EXPECT_GT(lost.to, 2.21) << "what pnrvsa reaches as it is shipped";
    EXPECT_EQ(lost.binds.severity, core::Severity::kError);
    const std::string farther = fixtures::with_key(fixed.toml, "law.end_torque_Nm", std::to_string(1.01 * lost.to));
    FixOptions look = options;
    look.most_judged = kOnlyLook;
    EXPECT_NE(find_fix(profile::parse_profile(farther, folder_ / "t.toml"), farther, look).end, Fix::End::kNothingToDo);
}

TEST_F(FixTest, IsTheSameEachTime) {
    const std::string toml = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")),
                                                 {{"k_pe.spring.max_travel_mm", "20"}, {"groove.throat_deg", "40"}});
    const FixOptions options{.file = folder_ / "fixed.toml", .make = [](const profile::Profile&) { return core::Findings{}; }};
    const profile::Profile profile = profile::parse_profile(toml, folder_ / "t.toml");
    const Fix first = find_fix(profile, toml, options), second = find_fix(profile, toml, options);
    EXPECT_FALSE(first.toml.empty());
    EXPECT_EQ(first.toml, second.toml);
    EXPECT_EQ(report::fix_json(first), report::fix_json(second));
}

TEST_F(FixTest, StopsWhenAsked) {
    const std::string toml = fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "k_se.spring.preload_rad", "0.0");
    int asked = 0;
    const FixOptions options{.file = folder_ / "fixed.toml", .stop = [&asked] { return ++asked > 5; }};
    EXPECT_THROW((void)find_fix(profile::parse_profile(toml, folder_ / "t.toml"), toml, options), core::Stopped);
}

/// Values that are at odds in the profile itself are bad input, as for `make`.
TEST_F(FixTest, RefusesWhatMakeRefuses) {
    const std::string toml = fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "k_pe.hub.boss_mm", "7.0");
    EXPECT_THROW((void)find_fix(profile::parse_profile(toml, folder_ / "t.toml"), toml, {.file = folder_ / "fixed.toml"}),
                 core::InvalidInput);
}

}  // namespace
}  // namespace fusee::search::fix
