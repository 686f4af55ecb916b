#pragma once
#include <cstddef>
#include <string_view>

/// Standard output of the program: writing there never throws, and what became of it is told once, at the end.
namespace fusee::app {

/// Opens closed standard files: otherwise the next opened file would take their number and receive the output.
void keep_standard_files();

/// Writes; nothing once a write has failed.
void print_out(std::string_view text);

/// Letters in a line of standard output: a terminal's width; elsewhere no line ends before its text does, so that `grep` finds it whole.
[[nodiscard]] std::size_t columns_out();

/// Has no write failed yet?
[[nodiscard]] bool is_output_open();

/// Flushes. @returns whether anybody still takes the output; a command that does nothing but print ends when nobody does
[[nodiscard]] bool flush_out();

/// The end of standard output. A reader that left (fusee keys | head) is no error. Any other loss is told on standard error, where that
/// works. @returns the program's exit code: `code`, or at least that of bad input if output was lost
[[nodiscard]] int close_out(int code);

/// Writes as much as `file` takes without waiting: for the end of a program that another thread may hold up.
void put_without_waiting(int file, std::string_view text) noexcept;

}  // namespace fusee::app
