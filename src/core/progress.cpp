#include "fusee/core/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>

#include "fusee/core/terminal.h"
#include "fusee/core/text.h"

namespace fusee::core {

namespace {
std::atomic<bool> g_hidden = false;
constexpr std::size_t kBarWidth = 30;
constexpr std::size_t kLeastRated = 20;  ///< items from which on a rate says more than the items themselves

/// " 8.3/s, 2:10 left"; nothing for few items.
std::string rate_text(std::size_t done, std::size_t total, double seconds) {
    if (total < kLeastRated || done == 0 || seconds <= 0.0) return "";
    const double rate = static_cast<double>(done) / seconds;
    const auto left = static_cast<long>(static_cast<double>(total - done) / rate + 0.5);
    const std::string hours = left >= 3600 ? fmt::format("{}:{:02}", left / 3600, left / 60 % 60) : fmt::format("{}", left / 60);
    return fmt::format(" {:.3g}/s, {}:{:02} left", rate, hours, left % 60);
}
}  // namespace

void hide_progress() { g_hidden = true; }

Progress::Progress(std::string title, std::size_t total, Of of)
    : title_(std::move(title)), total_(total), of_(of), terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (terminal_ && !g_hidden) say_error(of_ == Of::kStages ? "\r\x1b[K" : "\n");
}

void Progress::advance(const std::string& label) {
    const std::scoped_lock lock(mutex_);
    ++done_;
    draw(label);
}

void Progress::reach(std::size_t done, const std::string& label) {
    const std::scoped_lock lock(mutex_);
    if (done <= done_ && label == reached_) return;
    done_ = std::max(done_, done);  // work that begins again, with better values, is no step back
    if (terminal_ || label != reached_) draw(label);
    reached_ = label;
}

void Progress::note(const std::string& label) {
    const std::scoped_lock lock(mutex_);
    draw(label);
}

void Progress::draw(const std::string& label) const {
    if (g_hidden) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const std::string shown = printable(label);  // it may contain a file's name
    if (!terminal_) {
        if (of_ == Of::kStages && seconds < kSlow) return;
        say_error(fmt::format("{} {}/{}: {}\n", title_, done_, total_, shown));
        return;
    }
    const std::size_t done = std::min(done_, total_), filled = total_ == 0 ? kBarWidth : kBarWidth * done / total_;
    const std::string line = fmt::format("{} [{}{}] {}/{}{} {}", title_, std::string(filled, '#'), std::string(kBarWidth - filled, '.'),
                                         done, total_, rate_text(done, total_, seconds), shown);
    say_error("\r\x1b[K" + cut(line, terminal_columns(STDERR_FILENO) - 1));  // a line that wraps could not be overwritten
}

}  // namespace fusee::core
