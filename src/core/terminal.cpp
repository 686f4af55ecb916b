#include "fusee/core/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>

#include "fusee/core/lists.h"
#include "fusee/core/text.h"

namespace fusee::core {

namespace {

constexpr std::size_t kUsualColumns = 80, kLeastColumns = 40, kMostColumns = 10'000;

/// 0: not stated.
std::size_t stated_columns() {
    const char* text = std::getenv("COLUMNS");
    std::size_t columns = 0;
    if (text != nullptr) std::from_chars(text, text + std::string_view(text).size(), columns);
    return columns;
}

/// Where the text of a line's second column begins; more than half the width would leave too little for it.
std::size_t second_column(std::string_view line, std::size_t indent, std::size_t columns, std::size_t column) {
    std::size_t begin = indent + 2;
    if (column > indent + 1 && column < line.size() && line[column - 1] == ' ' && line[column] != ' ')
        begin = column;
    else if (const std::size_t gap = line.find("  ", indent); gap != std::string_view::npos)
        begin = std::min(line.find_first_not_of(' ', gap), line.size());
    return 2 * begin > columns ? indent + 2 : begin;
}

std::string fitted_line(std::string_view line, std::size_t columns, std::size_t column) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const bool copied = line.substr(indent).starts_with("fusee ") || line.find('\t') != std::string_view::npos;
    if (copied || letters(line) <= columns) return std::string(line);
    const std::size_t hang = second_column(line, indent, columns, column);
    std::string out;
    for (std::size_t width = columns; letters(line) > width; width = columns - hang) {
        const std::string begin = cut(line, width + 1);  // a space may stand behind the last letter
        std::size_t end = begin.find_last_of(' ');
        if (end == std::string::npos || begin.find_first_not_of(' ') > end) end = line.find(' ', begin.size());
        if (end == std::string_view::npos) break;
        out += std::string(line.substr(0, line.find_last_not_of(' ', end) + 1)) + "\n" + std::string(hang, ' ');
        line.remove_prefix(std::min(line.find_first_not_of(' ', end), line.size()));
    }
    return out + std::string(line);
}

/// Each line of the text by `change`; line ends stay.
template <class Change>
std::string by_line(std::string_view text, const Change& change) {
    std::string out;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        out += change(text.substr(0, end));
        if (end < text.size()) out += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

/// A word at the beginning of a line, with the colour of what it says.
struct Marked {
    std::string_view word, colour;
};
constexpr std::string_view kRed = "\x1b[1;31m", kYellow = "\x1b[1;33m", kCyan = "\x1b[36m", kPlain = "\x1b[0m";
constexpr std::array kMarked{Marked{"error", kRed}, Marked{"warning", kYellow}, Marked{"not judged", kCyan}, Marked{"fusee", kRed}};

std::string coloured_line(std::string_view line) {
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    for (const Marked& marked : kMarked) {
        const std::string_view rest = line.substr(begin);
        if (rest.starts_with(marked.word) && rest.substr(marked.word.size()).starts_with(':'))
            return fmt::format("{}{}{}{}{}", line.substr(0, begin), marked.colour, marked.word, kPlain, rest.substr(marked.word.size()));
    }
    return std::string(line);
}

}  // namespace

bool is_terminal(int file) { return ::isatty(file) != 0; }

std::size_t terminal_columns(int file) {
    std::size_t columns = stated_columns();
    winsize size{};
    if (columns == 0 && is_terminal(file) && ::ioctl(file, TIOCGWINSZ, &size) == 0) columns = size.ws_col;
    return columns == 0 ? kUsualColumns : std::clamp(columns, kLeastColumns, kMostColumns);
}

std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent, std::size_t hang) {
    std::string out, line(indent, ' ');
    bool empty = true;  // has this line no word yet?
    for (const std::string& word : pieces_of<std::string>(text, " ")) {
        if (word.empty()) continue;
        if (!empty && letters(line) + 1 + letters(word) > columns) {
            out += line + "\n";
            line.assign(indent + hang, ' ');
            empty = true;
        }
        line += (empty ? "" : " ") + word;
        empty = false;
    }
    return out + line;
}

std::string fitted(std::string_view text, std::size_t columns, std::size_t column) {
    return by_line(text, [=](std::string_view line) { return fitted_line(line, columns, column); });
}

std::string cut(std::string_view text, std::size_t columns) {
    std::size_t bytes = 0;
    for (std::size_t count = 0; count < columns && bytes < text.size(); ++count) bytes += first_character(text.substr(bytes)).bytes;
    return std::string(text.substr(0, bytes));
}

void say_error(std::string_view text) noexcept {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

bool is_coloured(Colour colour, int file) {
    if (colour != Colour::kAuto) return colour == Colour::kAlways;
    const char *none = std::getenv("NO_COLOR"), *kind = std::getenv("TERM");
    const bool refused = (none != nullptr && *none != '\0') || (kind != nullptr && std::string_view(kind) == "dumb");
    return !refused && is_terminal(file);
}

std::string coloured(std::string_view text) { return by_line(text, coloured_line); }

}  // namespace fusee::core
