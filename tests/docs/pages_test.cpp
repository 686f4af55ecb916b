#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "docs/markdown.h"
#include "fusee/core/file.h"

// What the documents promise without a command: links, pages that sources name, the module table, and the words of the glossary.
namespace fusee::docs {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = FUSEE_SOURCE_DIR;

std::set<std::string> matches_of(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) found.insert((*at)[1]);
    return found;
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

TEST(Pages, LinkToFilesThatExist) {
    std::size_t links = 0;
    for (const fs::path& page : markdown_files(kRoot))
        for (const std::string& link : matches_of(core::read_file(page), R"(\]\(([^)#\s]+)[^)\s]*\))")) {
            if (link.starts_with("http")) continue;
            ++links;
            EXPECT_TRUE(fs::exists(page.parent_path() / link)) << fs::relative(page, kRoot) << ": " << link;
        }
    EXPECT_GT(links, 200u);
}

TEST(Pages, ThatSourcesNameExist) {
    std::size_t named = 0;
    for (const char* folder : {"src", "include", "tests", "cmake", "templates", "profiles"})
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
            if (!entry.is_regular_file()) continue;
            for (const std::string& page : matches_of(core::read_file(entry.path()), R"(\b(docs/[a-z0-9_/-]+\.md)\b)")) {
                ++named;
                EXPECT_TRUE(fs::exists(kRoot / page)) << fs::relative(entry.path(), kRoot) << ": " << page;
            }
        }
    EXPECT_GT(named, 50u);
}

TEST(Pages, ContainNoWordThatTheGlossaryReplaces) {
    // Of the column "not" those words that have no other meaning. CHANGELOG.md and the glossary itself name them.
    const std::regex replaced(
        R"(foretell|foretold|\bkept[- ]back|by anybody|told apart|hangs on next|failure inside|reckoned|\brecut|required change|bench case|)"
        R"(\brooms?\b(?= `)|whereabouts|\bjudgement|hatted|\bgives? way|\bhence\b|\bthereby\b|\bwherefore\b|\bof one's own\b)",
        std::regex::icase);
    for (const fs::path& page : markdown_files(kRoot)) {
        if (page.filename() == "CHANGELOG.md" || page.filename() == "glossary.md") continue;
        std::istringstream lines(core::read_file(page));
        std::size_t number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            std::smatch word;
            EXPECT_FALSE(std::regex_search(line, word, replaced)) << fs::relative(page, kRoot) << ":" << number << ": " << word.str();
        }
    }
}

/// Module -> modules that it may include, as the table of docs/architecture.md states, in its order.
std::vector<std::pair<std::string, std::vector<std::string>>> module_table() {
    std::istringstream lines(core::read_file(kRoot / "docs/architecture.md"));
    const std::regex row(R"(\| *\d+ *\| `([a-z_]+)` \|[^|]*\|([^|]*)\|[^|]*\|)");
    std::vector<std::pair<std::string, std::vector<std::string>>> table;
    std::smatch cells;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, cells, row)) table.emplace_back(cells[1], words_of(cells[2]));
    return table;
}

TEST(ModuleTable, IsThatOfTheBuild) {
    std::vector<std::string> listed;
    for (const auto& [module, uses] : module_table()) {
        listed.push_back(module);
        const fs::path file = kRoot / "src" / module / "CMakeLists.txt";
        if (module == "app" || !fs::exists(file)) continue;
        std::smatch declared;
        const std::string text = core::read_file(file);
        std::vector<std::string> built;
        if (std::regex_search(text, declared, std::regex(R"(USES\s([a-z0-9_\s]*))"))) built = words_of(declared[1]);
        std::vector<std::string> stated = uses;
        std::erase(stated, "-");
        std::sort(stated.begin(), stated.end());
        std::sort(built.begin(), built.end());
        EXPECT_EQ(stated, built) << module;
    }
    std::smatch modules;
    const std::string top = core::read_file(kRoot / "CMakeLists.txt");
    ASSERT_TRUE(std::regex_search(top, modules, std::regex(R"(set\(FUSEE_MODULES ([a-z_\s]+)\))")));
    EXPECT_EQ(listed, words_of(modules[1])) << "the rows stand in the order of FUSEE_MODULES";
}

}  // namespace
}  // namespace fusee::docs
