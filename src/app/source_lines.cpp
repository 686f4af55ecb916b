#include "source_lines.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>

#include "fusee/core/lists.h"
#include "fusee/core/terminal.h"
#include "fusee/core/text.h"

namespace fusee::app {

namespace {

constexpr int kMostShown = 10;
constexpr std::uintmax_t kLargestShown = 10'000'000;         // bytes; a message must not take longer than the work
constexpr std::size_t kMostShownLetters = 64, kMargin = 16;  // of a long line, and beside it: 80 columns hold both

/// Line `number` from 1; false if the file has none.
bool read_line(const std::filesystem::path& file, std::size_t number, std::string& line) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none) || std::filesystem::file_size(file, none) > kLargestShown) return false;
    std::ifstream lines(file);
    for (std::size_t i = 0; i < number; ++i)
        if (!std::getline(lines, line)) return false;
    if (number == 1 && line.starts_with(core::kByteOrderMark)) line.erase(0, core::kByteOrderMark.size());
    std::replace(line.begin(), line.end(), '\t', ' ');
    if (line.ends_with('\r')) line.pop_back();
    return true;
}

/// The line with its number and a caret below byte `column` from 1.
std::string marked_line(const std::string& line, std::size_t number, std::size_t column) {
    const std::string before = core::printable(line.substr(0, column - 1)), whole = core::printable(line);
    const std::size_t shown = std::min(kMostShownLetters, core::terminal_columns(STDERR_FILENO) - kMargin), ahead = shown * 5 / 8;
    std::size_t place = core::letters(before), begin = 0;
    if (place > shown) begin = core::cut(whole, place - ahead).size(), place = ahead;
    const std::string margin(std::to_string(number).size(), ' ');
    return fmt::format("    {} | {}\n    {} | {}^\n", number, core::cut(whole.substr(begin), shown), margin, std::string(place, ' '));
}

}  // namespace

std::string with_source_lines(std::string_view message) {
    static const std::regex kPlace(R"(^ *(?:fusee: )?([^ ].*?):([0-9]{1,9}):([0-9]{1,9}): )");
    std::string out, line;
    int shown = 0;
    for (const std::string& text : core::pieces_of<std::string>(message, "\n")) {
        out += text + "\n";
        std::smatch place;
        if (shown == kMostShown || !std::regex_search(text, place, kPlace)) continue;
        const std::size_t number = std::stoul(place[2]), column = std::stoul(place[3]);
        if (number == 0 || column == 0 || !read_line(place[1].str(), number, line) || column > line.size() + 1) continue;
        out += marked_line(line, number, column);
        ++shown;
    }
    return out;
}

}  // namespace fusee::app
