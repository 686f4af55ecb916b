#pragma once
#include <chrono>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string>

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

}  // namespace fusee::core
