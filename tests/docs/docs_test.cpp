#include <gtest/gtest.h>
#include <sys/wait.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "docs/markdown.h"
#include "fusee/core/file.h"
#include "fusee/core/toml.h"
#include "fusee/profile/profile.h"
#include "shipped.h"

// README.md and docs/**/*.md: every TOML block is read, every command is run in a folder like a clone, and a text block below a command is
// its output. Blocks of TOML are whole profiles, which must be free of errors, or part of the profile that their mark names:
// `<!-- test: with profiles/pnrvsa.toml -->`. A block that cannot be run states the reason: `<!-- test: skip, REASON -->`. From
// `<!-- test: needs fusee-mujoco -->` on a page is skipped where that program was not built.
namespace fusee::docs {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = FUSEE_SOURCE_DIR;

bool is_tested(const Block& block) { return block.language == "sh" || block.language == "toml" || block.language == "text"; }

std::vector<std::string> pages_with_blocks() {
    std::vector<std::string> pages;
    for (const fs::path& page : markdown_files(kSource)) {
        const auto blocks = blocks_of(core::read_file(page));
        if (std::any_of(blocks.begin(), blocks.end(), is_tested)) pages.push_back(fs::relative(page, kSource).string());
    }
    return pages;
}

class Blocks : public ::testing::TestWithParam<std::string> {
protected:
    /// A folder that looks like a clone with fusee built.
    void SetUp() override {
        std::string pattern = (fs::path(::testing::TempDir()) / "fusee_docs_XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        fixtures::copy_shipped("profiles", folder_);
        fs::create_symlink(FUSEE_PROGRAM, folder_ / "fusee");
    }
    void TearDown() override { fs::remove_all(folder_); }

    struct Ended {
        int code = -1;
        std::string output;
    };
    /// The lines as one script; a command that fails ends it. Lines that build are skipped.
    [[nodiscard]] Ended run(const std::string& script) const {
        std::istringstream lines(script);
        std::string script_run = "set -e\n";
        for (std::string line; std::getline(lines, line);) {
            const bool builds = line.starts_with("cmake ") || line.starts_with("build/") || line.starts_with("./fusee test");
            if (builds) std::cout << GetParam() << ": skipped, it builds: " << line << "\n";
            script_run += builds ? "" : line + "\n";
        }
        core::write_file(folder_ / ".script", script_run);
        const std::string command =
            "cd '" + folder_.string() + "' && PATH='" + folder_.string() + "':$PATH timeout 300 bash .script >.output 2>&1 </dev/null";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, core::read_file(folder_ / ".output")};
    }

    /// A whole profile: can be read, and has no errors.
    void check_profile(const Block& block) const {
        core::write_file(folder_ / "block.toml", block.text);
        const Ended checked = run("./fusee check block.toml");
        EXPECT_EQ(checked.code, 0) << GetParam() << ":" << block.line << ": a profile that cannot be made\n" << checked.output;
    }
    /// A part of a profile, which replaces the same keys of another one.
    void check_piece(const Block& block, const std::string& profile) const {
        const fs::path path = folder_ / profile;
        toml::table whole = core::parse_toml(core::read_file(path), path.string());
        merge(whole, core::parse_toml(block.text, GetParam()));
        std::ostringstream text;
        text << whole;
        EXPECT_NO_THROW((void)profile::parse_profile(text.str(), path)) << GetParam() << ":" << block.line << "\n" << text.str();
    }

    fs::path folder_;

private:
    static void merge(toml::table& into, const toml::table& from) {
        for (const auto& [key, node] : from) {
            toml::table* inner = into[key].as_table();
            if (inner != nullptr && node.is_table())
                merge(*inner, *node.as_table());
            else
                into.insert_or_assign(key, node);
        }
    }
};

TEST_P(Blocks, DoWhatThePageShows) {
    int run_blocks = 0, skipped = 0;
    Ended last;
    bool printed = false;  // did the block above run?
    for (const Block& block : blocks_of(core::read_file(kSource / GetParam()))) {
        const std::string place = GetParam() + ":" + std::to_string(block.line);
        SCOPED_TRACE(place);
        if (!is_tested(block)) continue;
        const std::string needed = block.after("needs");
        if (!needed.empty() && !fs::exists(fs::path(FUSEE_PROGRAM).parent_path() / needed))
            GTEST_SKIP() << place << " NOT TESTED: it needs " << needed
                         << ", which is built where its package of packages.txt is installed";
        if (block.mark.starts_with("skip")) {
            EXPECT_FALSE(block.after("skip").empty()) << "a reason";
            std::cout << place << ": skipped: " << block.after("skip") << "\n";
            ++skipped;
            printed = printed && block.language != "sh";
            continue;
        }
        ++run_blocks;
        if (block.language == "toml") {
            const std::string base = block.after("with");
            base.empty() ? check_profile(block) : check_piece(block, base);
        } else if (block.language == "sh") {
            last = run(block.text);
            printed = true;
            EXPECT_EQ(last.code, 0) << block.text << last.output;
        } else {
            EXPECT_TRUE(printed) << "output of no command";
            for (const std::string& line : missing_lines(block.text, last.output))
                ADD_FAILURE() << "shown, but not printed: " << line << "\nprinted:\n" << last.output;
        }
    }
    std::cout << GetParam() << ": " << run_blocks << " blocks run, " << skipped << " skipped\n";
}

INSTANTIATE_TEST_SUITE_P(Docs, Blocks, ::testing::ValuesIn(pages_with_blocks()), [](const auto& page) {
    std::string name = page.param;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});

TEST(Markdown, FindsBlocksWithTheirMarks) {
    const auto blocks =
        blocks_of("a\n```sh\nx\n```\n\n<!-- test: skip, it is long -->\n  ```toml\n  [a]\n    b = 1\n  ```\n```\nplain\n```\n");
    ASSERT_EQ(blocks.size(), 3u);
    EXPECT_EQ(blocks[0].text, "x\n");
    EXPECT_EQ(blocks[0].line, 2u);
    EXPECT_EQ(blocks[0].mark, "");
    EXPECT_EQ(blocks[1].text, "[a]\n  b = 1\n");
    EXPECT_EQ(blocks[1].after("skip"), "it is long");
    EXPECT_EQ(blocks[2].language, "");
}

TEST(Markdown, ComparesLinesInOrder) {
    const std::string found = "made  4.63 s  out\n  one 1.25, allowed 2\nlast\n";
    EXPECT_TRUE(missing_lines("made 0.10 s out\n...\nlast\n", found).empty());
    EXPECT_TRUE(missing_lines("one 1.25, ...\n", found).empty());
    EXPECT_EQ(missing_lines("one 1.26, ...\n", found), (std::vector<std::string>{"one 1.26, ..."}));
    EXPECT_EQ(missing_lines("last\nmade 1 s out\n", found), (std::vector<std::string>{"made 1 s out"})) << "order";
    EXPECT_EQ(missing_lines("mad\n", found).size(), 1u) << "the whole line";
}

}  // namespace
}  // namespace fusee::docs
