#pragma once
#include <chrono>
#include <string>
#include <vector>

namespace fusee::core {

/// What a program left behind when it ended.
struct ProcessResult {
    int code = -1;       ///< its exit code; -1 if a signal ended it
    std::string output;  ///< standard output and error as they came
    bool in_time = true;
};

/// Runs a program found on PATH without a shell, its input empty; it is ended if still running after `timeout`.
/// @param words the program and its arguments
/// @param about the file that an error names
/// @throws IoError if it cannot be started
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& words, const std::string& about, std::chrono::seconds timeout);

/// Is there a program of this name on PATH?
[[nodiscard]] bool on_path(const std::string& program);

/// The last 600 characters of what a program said, for an error.
[[nodiscard]] std::string last_words(const std::string& output);

}  // namespace fusee::core
