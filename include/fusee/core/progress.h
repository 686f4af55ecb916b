#pragma once
#include <chrono>
#include <csignal>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <shared_mutex>
#include <string>

/// The progress of long work, and its end: one signal ends the program within a second, wherever it is. `catch_interrupts` asks the work to
/// stop; `end_after_signal` ends what does not.
namespace fusee::core {

/// No Progress shows anything from now on (-q).
void hide_progress();

/// Shows the progress of long work on stderr: a bar on a terminal, plain lines otherwise. Thread-safe.
class Progress {
public:
    enum class Of {
        kItems,   ///< each item is a line; the bar stays
        kStages,  ///< stages of one item: lines only after kSlow; the bar is wiped at the end
    };
    static constexpr double kSlow = 10.0;  ///< [s]
    Progress(std::string title, std::size_t total, Of of = Of::kItems);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Counts one finished item, or a stage that begins; `label` names it.
    void advance(const std::string& label);
    /// Sets the count of finished items, for work whose parts differ in size; without a terminal, a line only for a new label.
    void reach(std::size_t done, const std::string& label);
    /// Announces a long step: shown behind the bar, or as a line.
    void note(const std::string& label);

private:
    void draw(const std::string& label) const;

    std::string title_, reached_;
    std::size_t total_, done_ = 0;
    Of of_;
    bool terminal_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
};

/// Makes Ctrl-C (SIGINT) and SIGTERM a request to stop: finished work stays, nothing new is begun. A second signal ends the program at
/// once.
void catch_interrupts();
[[nodiscard]] bool interrupted();

/// Thrown by a caller's progress function to leave long work that has no other way out; the app ends with exit code 130.
struct Stopped final : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return "stopped"; }
};

/// Time that the work has to end by itself after the first signal [ms].
inline constexpr int kGrace_ms = 600;

/// Ends the program kGrace_ms after the first signal (sooner where a limit of the processor time leaves less): called programs are
/// killed, temporary folders removed, `farewell` is called with the signal, and its result is the exit code. It runs on a thread of its own
/// while the others still work, so it may not wait for a lock or for a reader. Without a thread (ulimit -u) nothing is done. Called once,
/// after catch_interrupts.
void end_after_signal(std::function<int(int signal)> farewell);

/// The signal that asked to stop; 0: none. SIGXCPU: the processor time of the user's limit is used up.
[[nodiscard]] int stop_signal();

/// While one lives, the program is not ended: for steps that belong together, such as the moves of finished files. Short ones only.
class StopHold {
public:
    StopHold();

private:
    std::shared_lock<std::shared_timed_mutex> lock_;
};

}  // namespace fusee::core
