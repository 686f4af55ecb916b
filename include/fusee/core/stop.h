#pragma once
#include <csignal>
#include <functional>
#include <shared_mutex>

/// One signal ends the program within a second, wherever it is: `catch_interrupts` of progress.h asks the work to stop; this ends what
/// does not.
namespace fusee::core {

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
