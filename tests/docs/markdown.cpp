#include "docs/markdown.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace fusee::docs {

namespace {

constexpr std::string_view kFence = "```", kMark = "<!-- test: ", kMarkEnd = " -->";

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string trimmed(const std::string& line) {
    const auto begin = line.find_first_not_of(" \t"), end = line.find_last_not_of(" \t");
    return begin == std::string::npos ? "" : line.substr(begin, end - begin + 1);
}

/// One space for several, and "N.NN s" for every time.
std::string comparable(const std::string& line) {
    static const std::regex kSpaces("[ \t]+"), kSeconds(R"(\b\d+(\.\d+)? s\b)");
    return std::regex_replace(std::regex_replace(trimmed(line), kSpaces, " "), kSeconds, "N.NN s");
}

/// Does `found` contain the pieces between the dots, the first at its beginning and the last at its end?
bool matches(const std::string& shown, const std::string& found) {
    std::size_t at = 0, begin = 0;
    while (true) {
        const std::size_t dots = shown.find("...", begin);
        const std::string piece = trimmed(shown.substr(begin, dots == std::string::npos ? dots : dots - begin));
        const std::size_t place = found.find(piece, at);
        if (place == std::string::npos || (begin == 0 && place != 0)) return false;
        if (dots == std::string::npos) return found.ends_with(piece);
        at = place + piece.size();
        begin = dots + 3;
    }
}

}  // namespace

std::string Block::after(std::string_view word) const {
    if (!mark.starts_with(word)) return "";
    const std::string rest = mark.substr(word.size());
    return rest.substr(std::min(rest.size(), rest.find_first_not_of(" ,")));
}

std::vector<std::filesystem::path> markdown_files(const std::filesystem::path& root) {
    std::vector<std::filesystem::path> files;
    for (const char* page : {"README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"}) files.push_back(root / page);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<Block> blocks_of(const std::string& markdown) {
    std::vector<Block> blocks;
    const std::vector<std::string> lines = lines_of(markdown);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t indent = lines[i].find_first_not_of(' ');
        if (indent == std::string::npos || !std::string_view(lines[i]).substr(indent).starts_with(kFence)) continue;
        Block& block = blocks.emplace_back(Block{i + 1, trimmed(lines[i].substr(indent + kFence.size())), "", ""});
        const std::string above = i > 0 ? trimmed(lines[i - 1]) : "";
        if (above.starts_with(kMark) && above.ends_with(kMarkEnd))
            block.mark = above.substr(kMark.size(), above.size() - kMark.size() - kMarkEnd.size());
        for (++i; i < lines.size() && trimmed(lines[i]) != kFence; ++i)
            block.text += (lines[i].size() > indent ? lines[i].substr(indent) : "") + "\n";
    }
    return blocks;
}

std::vector<std::string> missing_lines(const std::string& shown, const std::string& found) {
    const std::vector<std::string> printed = lines_of(found);
    std::vector<std::string> missing;
    std::size_t next = 0;
    for (const std::string& line : lines_of(shown)) {
        const std::string wanted = comparable(line);
        if (wanted.empty()) continue;
        std::size_t at = next;
        while (at < printed.size() && !matches(wanted, comparable(printed[at]))) ++at;
        if (at < printed.size())
            next = wanted == "..." ? next : at + 1;
        else
            missing.push_back(line);
    }
    return missing;
}

}  // namespace fusee::docs
