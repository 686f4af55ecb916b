#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fusee::docs {

/// A fenced block of a Markdown page.
struct Block {
    std::size_t line = 0;  ///< of its fence, from 1
    std::string language;  ///< "sh", "toml", "text"; "" for none
    std::string text;      ///< its lines, without the indentation of the fence
    /// Of the comment `<!-- test: MARK -->` on the line above its fence: "skip, REASON", "profile", "with profiles/pnrvsa.toml".
    std::string mark;

    /// What follows the word with which the mark begins; "" if it begins with another one.
    [[nodiscard]] std::string after(std::string_view word) const;
};

/// README.md, CHANGELOG.md, CONTRIBUTING.md, SECURITY.md and docs/**/*.md of the clone in `root`, sorted.
[[nodiscard]] std::vector<std::filesystem::path> markdown_files(const std::filesystem::path& root);

[[nodiscard]] std::vector<Block> blocks_of(const std::string& markdown);

/// The lines of `shown` that `found` lacks in their order. Spaces count as one; "..." stands for anything; times in seconds are
/// not compared.
[[nodiscard]] std::vector<std::string> missing_lines(const std::string& shown, const std::string& found);

}  // namespace fusee::docs
