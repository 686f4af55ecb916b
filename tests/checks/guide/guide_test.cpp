#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "checks/known_bad.h"
#include "fusee/core/file.h"

// docs/guides/add-a-check.md: its file is registered by its name, its known bad part passes the tests that it names, its files exist.
namespace fusee::checks {

std::vector<Case> shaft_cases() {
    return {
#include "row.h"
    };
}
std::vector<Case> cable_cases() { return {}; }
std::vector<Case> groove_cases() { return {}; }
std::vector<Case> spring_cases() { return {}; }
std::vector<Case> structure_cases() { return {}; }
std::vector<Case> roller_cases() { return {}; }
std::vector<Case> process_cases() { return {}; }
std::vector<Case> machine_cases() { return {}; }
std::vector<Case> assembly_cases() { return {}; }

TEST(Guide, TheFileIsRegisteredByItsName) {
    ASSERT_NE(find_rule("shaft.boss_height"), nullptr);
    const Fixture high = bad(shaft_cases().front());
    std::size_t found = 0;
    for (const core::Finding& f : check(high.design())) found += f.rule == "shaft.boss_height";
    EXPECT_EQ(found, 1u);
}

TEST(Guide, NamesFilesThatExist) {
    const std::filesystem::path source = FUSEE_SOURCE_DIR;
    const std::string page = core::read_file(source / "docs/guides/add-a-check.md");
    const std::regex path("`((?:src|include|tests)/[a-z_/]+\\.(?:cpp|h))`");
    int files = 0;
    for (std::sregex_iterator at(page.begin(), page.end(), path), end; at != end; ++at, ++files) {
        const std::string name = (*at)[1];
        EXPECT_TRUE(std::filesystem::exists(source / name) || name == "src/checks/rules/boss.cpp") << name;
    }
    EXPECT_GT(files, 5);
}

}  // namespace fusee::checks
