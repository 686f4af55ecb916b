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

TEST_P(Suggested, ChangesAreReadAsTheyStand) {
    for (const core::Finding& f : checks::check(checks::bad(GetParam()).design()))
        for (const core::Changes& changes : f.suggestion.changes())
            for (const char* name : {"pnrvsa", "first_prototype", "examples/roller_follower", "examples/laser_stack"})
                EXPECT_EQ(refusal(name, changes), "") << name << ": " << f.suggestion.text();
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
