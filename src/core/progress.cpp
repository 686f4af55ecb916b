#include "fusee/core/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>

#include "fusee/core/process.h"
#include "fusee/core/text.h"

namespace fusee::core {

namespace {
volatile std::sig_atomic_t g_interrupted = 0;
constexpr std::size_t kBarWidth = 30;
}  // namespace

Progress::Progress(std::string title, std::size_t total)
    : title_(std::move(title)), total_(total), terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (terminal_) fmt::print(stderr, "\n");
}

void Progress::advance(const std::string& label) {
    const std::scoped_lock lock(mutex_);
    ++done_;
    draw(label);
}

void Progress::note(const std::string& label) {
    const std::scoped_lock lock(mutex_);
    draw(label);
}

void Progress::draw(const std::string& label) const {
    const std::string shown = printable(label);  // it may contain a file's name
    if (!terminal_) {
        fmt::print(stderr, "{} {}/{}: {}\n", title_, done_, total_, shown);
        return;
    }
    const std::size_t filled = total_ == 0 ? kBarWidth : kBarWidth * done_ / total_;
    fmt::print(stderr, "\r\x1b[K{} [{}{}] {}/{} {}", title_, std::string(filled, '#'), std::string(kBarWidth - filled, '.'), done_, total_,
               shown);
    std::fflush(stderr);
}

void catch_interrupts() {
    const auto handler = [](int signal) {
        if (g_interrupted != 0) {
            end_processes();
            std::signal(signal, SIG_DFL);
            (void)std::raise(signal);
        }
        g_interrupted = 1;
    };
    std::signal(SIGINT, handler);
    std::signal(SIGTERM, handler);
}

bool interrupted() { return g_interrupted != 0; }

}  // namespace fusee::core
