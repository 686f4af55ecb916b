#include <glib.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "docs/markdown.h"
#include "fusee/core/file.h"
#include "shipped.h"

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

/// PCRE2 as GLib wraps it: std::regex needs 18 s for these words in the sources.
class Pattern {
public:
    Pattern(const char* pattern, GRegexCompileFlags flags)
        : regex_(g_regex_new(pattern, static_cast<GRegexCompileFlags>(flags | G_REGEX_OPTIMIZE), G_REGEX_MATCH_DEFAULT, nullptr),
                 g_regex_unref) {
        if (!regex_) throw std::invalid_argument(pattern);
    }
    [[nodiscard]] std::optional<std::string> first_in(const std::string& text) const {
        GMatchInfo* info = nullptr;
        std::optional<std::string> match;
        if (g_regex_match(regex_.get(), text.c_str(), G_REGEX_MATCH_DEFAULT, &info) != FALSE) {
            char* found = g_match_info_fetch(info, 0);
            match = found;
            g_free(found);
        }
        g_match_info_free(info);
        return match;
    }

private:
    std::unique_ptr<GRegex, decltype(&g_regex_unref)> regex_;
};

/// Words that a term of the glossary has replaced and that have no other meaning, or that meaning only: matched in any case.
const Pattern kReplacedWords(
    R"(foretell|foretold|\bkept[-_ ]?back|by anybody|told apart|\bhangs? on next|failure inside|reckoned|\brecut|required change|)"
    R"(bench case|whereabouts|\bjudgement|hatted|\bgives? way|\bhence\b|\bthereby\b|\bwherefore\b|\bof one's own\b)",
    G_REGEX_CASELESS);
/// Words that are old terms in code and its comments: in a document they may be ordinary English, or name a public key.
const Pattern kReplacedTerms(
    R"(\brooms?\b|\broom_mm\b|look_?ahead|at_their_end|\bknobs?\b|\boutlook\b|cable_give|\blay_flat|\blean(s|ing)?\b|\bclimb(s|ing)?\b|)"
    R"(\bnat\b|(cable|contour)_?stretch\b\s*(\{|\w+ =)|bench_case|"alike"|\balike\(|(extreme|protocol)_width|EffectiveLimit>? bars?\b)",
    G_REGEX_CASELESS);
/// Types that were renamed.
const Pattern kReplacedTypes(
    R"(\b(struct|class|enum class) (Strain|Whereabouts|Judgement|Told|Knob|Tried|Outlook|Price|Weighing|Stretch|Bar|Card|Room|Reach)\b)",
    G_REGEX_DEFAULT);

/// What may contain a replaced word: deprecated keys that are written or read for one more version, a public rule id, ordinary English.
const char* const kAllowed[] = {"\"kept_back.json\"",
                                "\"kept_back_halved\"",
                                "\"kept_back_before\"",
                                "\"kept_back_after\"",
                                "{\"outlook\", \"headline\"}",
                                "\"outlook\", \"headline\"",
                                "{\"alike\", \"signature_similarity\"}",
                                "\"hatted_sensitivity_m_per_N\"",
                                "stack.climb",
                                "climb milling",
                                "the room's temperature"};

std::string without_allowed(std::string line) {
    for (const std::string allowed : kAllowed)
        for (std::size_t at = line.find(allowed); at != std::string::npos; at = line.find(allowed)) line.erase(at, allowed.size());
    return line;
}

void expect_no_match(const fs::path& file, const std::vector<const Pattern*>& words) {
    std::istringstream lines(core::read_file(file));
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        line = without_allowed(std::move(line));
        for (const Pattern* replaced : words)
            EXPECT_EQ(replaced->first_in(line), std::nullopt) << fs::relative(file, kRoot) << ":" << number;
    }
}

TEST(Pages, ContainNoWordThatTheGlossaryReplaces) {
    const Pattern room(R"(\brooms?\b(?= `))", G_REGEX_CASELESS);  // of a module
    for (const fs::path& page : markdown_files(kRoot))
        if (page.filename() != "CHANGELOG.md" && page.filename() != "glossary.md") expect_no_match(page, {&kReplacedWords, &room});
}

TEST(Sources, ContainNoWordThatTheGlossaryReplaces) {
    std::size_t files = 0;
    for (const char* folder : {"src", "include", "templates", "profiles"})
        for (const fs::path& file : fixtures::shipped_files(folder)) {
            if (!std::set<std::string>{".h", ".cpp", ".scad", ".toml", ".csv", ".txt", ".in"}.contains(file.extension().string())) continue;
            ++files;
            expect_no_match(kRoot / file, {&kReplacedWords, &kReplacedTerms, &kReplacedTypes});
        }
    EXPECT_GT(files, 500u);
}

TEST(Sources, AreSearchedForReplacedWords) {
    for (const char* line :
         {"struct Room {", "f.what = \"room beside it\";", "/// What the cable gives way.", "double lean = 0.0;", "1 nat"})
        EXPECT_TRUE(kReplacedWords.first_in(line) || kReplacedTerms.first_in(line)) << line;
    EXPECT_TRUE(kReplacedTypes.first_in("struct Told {"));
    EXPECT_EQ(without_allowed("{\"stack.climb\", 1}"), "{\"\", 1}");
    EXPECT_FALSE(kReplacedTerms.first_in("the national climate, a clean bedroom"));
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

/// What all parts of a module use, each by its module: "report_page" is a part of `report`.
std::vector<std::string> built_uses(const std::string& module, const std::string& cmake, const std::set<std::string>& modules) {
    static const std::regex kUses(R"(USES\s([a-z0-9_\s]*))");
    std::set<std::string> uses;
    for (std::sregex_iterator at(cmake.begin(), cmake.end(), kUses), end; at != end; ++at)
        for (const std::string& word : words_of((*at)[1])) uses.insert(modules.contains(word) ? word : word.substr(0, word.rfind('_')));
    uses.erase(module);
    return {uses.begin(), uses.end()};
}

TEST(ModuleTable, IsThatOfTheBuild) {
    std::set<std::string> names;
    for (const auto& [module, uses] : module_table()) names.insert(module);
    std::vector<std::string> listed;
    for (const auto& [module, uses] : module_table()) {
        listed.push_back(module);
        const fs::path file = kRoot / "src" / module / "CMakeLists.txt";
        if (module == "app" || !fs::exists(file)) continue;
        std::vector<std::string> stated = uses;
        std::erase(stated, "-");
        std::sort(stated.begin(), stated.end());
        EXPECT_EQ(stated, built_uses(module, core::read_file(file), names)) << module;
    }
    std::smatch modules;
    const std::string top = core::read_file(kRoot / "CMakeLists.txt");
    ASSERT_TRUE(std::regex_search(top, modules, std::regex(R"(set\(FUSEE_MODULES ([a-z_\s]+)\))")));
    EXPECT_EQ(listed, words_of(modules[1])) << "the rows stand in the order of FUSEE_MODULES";
}

}  // namespace
}  // namespace fusee::docs
