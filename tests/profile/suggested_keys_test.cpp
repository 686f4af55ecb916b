#include <gtest/gtest.h>

#include "checks/known_bad.h"
#include "fusee/core/change.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/profile/edit.h"

// Law: a change that a rule suggests can be written into a profile as it is: the reader accepts it, and no other key is missing.
namespace fusee::profile {
namespace {

std::filesystem::path shipped(const char* name) {
    return std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles" / (std::string(name) + ".toml");
}

/// What the reader says of the profile with the changes made; "" if it takes them, or if the first key has no meaning there.
std::string refusal(const char* name, const core::Changes& changes) {
    const std::string toml = core::read_file(shipped(name));
    const Profile profile = parse_profile(toml, shipped(name));
    if (!value_text(profile, changes.front().key)) return "";
    if (changes.front().key.starts_with("law.")) return "";  // good for the law of the part, not for this one's
    const auto of_arm = [](const core::Change& change) { return change.key.ends_with(".roller.pivot_mm"); };
    if (std::any_of(changes.begin(), changes.end(), of_arm) && !value_text(profile, "k_pe.roller.pivot_mm")) return "";  // it has a slide
    std::vector<Edit> edits;
    for (const core::Change& change : changes) edits.push_back({change, ""});
    try {
        (void)parse_profile(with_edits(toml, profile, edits), shipped(name));
        return "";
    } catch (const core::InvalidInput& e) {
        return e.what();
    }
}

class Suggested : public testing::TestWithParam<checks::Case> {};

/// Does the profile's part have a boss, which changes of an overhung hub rest on?
bool has_boss(const char* name, const std::string& part) {
    const auto boss = value_text(parse_profile(core::read_file(shipped(name)), shipped(name)), part + ".hub.boss_mm");
    return boss && std::stod(*boss) > 0.0;
}

TEST_P(Suggested, ChangesAreReadAsTheyStand) {
    const auto fixture = checks::bad(GetParam());
    const bool on_boss = fixture.part.options.hub.kind == solid::HubKind::kOverhung;
    int read = 0, suggested = 0;
    for (const core::Finding& f : checks::check(fixture.design()))
        for (const core::Changes& changes : f.suggestion.changes()) {
            ++suggested;
            for (const char* name : {"pnrvsa", "first_prototype", "examples/roller_follower", "examples/laser_stack"}) {
                const std::string& key = changes.front().key;
                if (on_boss && key.ends_with(".hub.lock") && !has_boss(name, key.substr(0, key.find('.')))) continue;
                EXPECT_EQ(refusal(name, changes), "") << name << ": " << f.suggestion.text();
                ++read;
            }
        }
    EXPECT_TRUE(read > 0 || suggested == 0) << "no profile took the change";
}

std::string test_name(const testing::TestParamInfo<checks::Case>& instance) {
    std::string name = std::string(instance.param.rule) + "_" + instance.param.name;
    std::erase_if(name, [](char c) { return c == ' ' || c == '%'; });
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Rules, Suggested, testing::ValuesIn(checks::all_cases()), test_name);

}  // namespace
}  // namespace fusee::profile
