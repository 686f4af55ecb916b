#pragma once
#include <cstddef>
#include <string>
#include <string_view>

/// The terminal of a person: its width, and the words that it shows in colour.
namespace fusee::core {

/// True if a file number, such as STDOUT_FILENO, is a terminal.
[[nodiscard]] bool is_terminal(int file);

/// Letters in a line for a person: COLUMNS of the environment, else the width of the terminal on `file` (1: standard output), else 80; at
/// least 40.
[[nodiscard]] std::size_t terminal_columns(int file = 1);

/// The text in lines of at most `columns` letters, broken at spaces; each line begins with `indent` spaces, and each but the first with
/// `hang` more. A word that is longer stays whole. Without end of line.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent = 0, std::size_t hang = 0);

/// Each line of more than `columns` letters broken at spaces. What follows stands below the line's second column of text: behind its first
/// gap of two spaces or at `column`, else two spaces deeper than the line. A line with a tab, and one that begins with the command "fusee",
/// stays whole: they are copied.
[[nodiscard]] std::string fitted(std::string_view text, std::size_t columns, std::size_t column = 0);

/// The first `columns` letters.
[[nodiscard]] std::string cut(std::string_view text, std::size_t columns);

/// Writes to standard error; what it does not take is dropped: a message must not end the work that it is about.
void say_error(std::string_view text) noexcept;

/// When severity words are coloured.
enum class Colour { kAuto, kAlways, kNever };
/// kAuto: on a terminal, unless the variable NO_COLOR is set and not empty (no-color.org) or TERM is "dumb".
[[nodiscard]] bool is_coloured(Colour colour, int file);

/// The text with the severity at the beginning of its lines coloured ("error", "not judged", "warning"), and "fusee:". Nothing else is.
[[nodiscard]] std::string coloured(std::string_view text);

}  // namespace fusee::core
