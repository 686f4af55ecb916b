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

/// Limits of a child process.
struct ChildLimits {
    std::chrono::seconds time{60};                     ///< CPU time
    std::chrono::seconds clock{600};                   ///< wall-clock time: the machine may have other work
    std::size_t memory_bytes = std::size_t{4} << 30;   ///< address space; not limited in builds with a sanitizer
    std::size_t output_bytes = std::size_t{64} << 20;  ///< standard output
};

/// How a child process ended.
struct ChildResult {
    enum class End {
        kExited,         ///< `code` is its exit code
        kSignalled,      ///< `code` is the signal
        kOutOfTime,      ///< CPU or wall-clock time
        kTooMuchOutput,  ///< more than `output_bytes`
    };
    End end = End::kExited;
    int code = 0;
    std::string output;  ///< its standard output, complete if it exited
};

/// Applies `limits` to the calling process, a child started by `run_child`: address space, CPU time, no core file; it is killed when the
/// thread that started it ends. The child calls this first.
void limit_this_process(const ChildLimits& limits);

/// From here on the calling process opens nothing: each open, socket, pipe or memory file fails with "too many open files" before the
/// system looks at the name, so that no FIFO blocks either; a program that it starts cannot load its libraries. Files that are open stay
/// usable, and nothing is written to regular ones. It cannot be undone. No limit in builds with a sanitizer, which reads files itself.
/// @pre libraries that are loaded when they are needed (loaded_function) are there
void open_no_more_files();

/// Runs a program, without a shell, that may crash, loop or take all memory: only the child ends then, and the result says how.
/// Its input is empty, its standard error is discarded (kept in builds with a sanitizer, which report there). Thread-safe: posix_spawn
/// instead of fork. The child itself applies the limits of memory and CPU time.
/// @param words the program's path and its arguments
/// @param about the file that an error names
/// @throws IoError if it cannot be started; Stopped if `interrupted()` while it runs
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& words, const std::string& about, const ChildLimits& limits);

}  // namespace fusee::core
