#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "docs/markdown.h"
#include "fusee/core/file.h"
#include "shipped.h"

// What the documents promise without a command: links, pages that sources name, and the module table.
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

// The site's navigation (mkdocs.yml) leads to every page, and to no other.
TEST(Pages, AllStandInTheNavigationOfTheSite) {
    const std::string site = core::read_file(kRoot / "mkdocs.yml");
    const std::set<std::string> listed = matches_of(site.substr(site.find("\nnav:")), "([a-zA-Z0-9_/.-]+\\.md)");
    std::set<std::string> pages;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / "docs"))
        if (entry.path().extension() == ".md") pages.insert(fs::relative(entry.path(), kRoot / "docs").string());
    EXPECT_EQ(listed, pages);
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
        for (const fs::path& file : fixtures::shipped_files(folder))
            for (const std::string& page : matches_of(core::read_file(kRoot / file), R"(\b(docs/[a-z0-9_/-]+\.md)\b)")) {
                ++named;
                EXPECT_TRUE(fs::exists(kRoot / page)) << file << ": " << page;
            }
    EXPECT_GT(named, 50u);
}

/// Module and layer, as the table of docs/architecture.md states, in its order.
std::vector<std::pair<std::string, int>> module_table() {
    std::istringstream lines(core::read_file(kRoot / "docs/architecture.md"));
    const std::regex row(R"(\| *(\d+) *\| `([a-z_]+)` \|[^|]*\|)");
    std::vector<std::pair<std::string, int>> table;
    std::smatch cells;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, cells, row)) table.emplace_back(cells[2], std::stoi(cells[1]));
    return table;
}

/// What all parts of a module use, each by its module: "report_page" is a part of `report`.
std::set<std::string> built_uses(const std::string& module, const std::string& cmake, const std::map<std::string, int>& modules) {
    static const std::regex kUses(R"(USES\s([a-z0-9_\s]*))");
    std::set<std::string> uses;
    for (std::sregex_iterator at(cmake.begin(), cmake.end(), kUses), end; at != end; ++at)
        for (const std::string& word : words_of((*at)[1])) uses.insert(modules.contains(word) ? word : word.substr(0, word.rfind('_')));
    uses.erase(module);
    return uses;
}

TEST(ModuleTable, IsThatOfTheBuild) {
    const auto table = module_table();
    const std::map<std::string, int> layers(table.begin(), table.end());
    std::vector<std::string> listed;
    for (const auto& [module, layer] : table) {
        listed.push_back(module);
        const fs::path file = kRoot / "src" / module / "CMakeLists.txt";
        if (module == "app" || !fs::exists(file)) continue;
        for (const std::string& used : built_uses(module, core::read_file(file), layers)) {
            ASSERT_TRUE(layers.contains(used)) << module << " uses " << used;
            EXPECT_LT(layers.at(used), layer) << module << " uses " << used;
        }
    }
    std::smatch modules;
    const std::string top = core::read_file(kRoot / "CMakeLists.txt");
    ASSERT_TRUE(std::regex_search(top, modules, std::regex(R"(set\(FUSEE_MODULES ([a-z_\s]+)\))")));
    EXPECT_EQ(listed, words_of(modules[1])) << "the rows stand in the order of FUSEE_MODULES";
}

}  // namespace
}  // namespace fusee::docs
