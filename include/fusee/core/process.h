#pragma once
#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace fusee::core {

/// The end of a program.
struct ProcessResult {
    int code = -1;       ///< its exit code; -1 if a signal ended it
    std::string output;  ///< the end of standard output and error, in order of arrival, at most `kept` bytes
    bool in_time = true;
    bool whole = true;  ///< false: the beginning of the output was dropped
};

/// Bytes of output kept for an error message.
inline constexpr std::size_t kKeptOutput = 1'000'000;

/// Runs a program found on PATH without a shell, with empty input and LC_ALL=C.UTF-8, in a separate process group: Ctrl-C does not reach
/// it, and its children end with it; it ends when fusee does, also by kill -9. It is ended if still running after `timeout`, whether it
/// prints or not.
/// @param words the program and its arguments
/// @param about the file that an error names
/// @param kept bytes of output; earlier output is dropped
/// @throws IoError if it cannot be started; Stopped if `interrupted()` while it runs
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& words, const std::string& about, std::chrono::seconds timeout,
                                        std::size_t kept = kKeptOutput);

/// Ends all running programs: for a signal handler.
void end_processes() noexcept;

/// Is a program of this name on PATH?
[[nodiscard]] bool on_path(const std::string& program);

/// The last 600 characters of a program's output, for an error.
[[nodiscard]] std::string last_words(const std::string& output);

}  // namespace fusee::core
