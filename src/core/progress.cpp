#include "fusee/core/progress.h"

#include <fmt/format.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <thread>
#include <utility>

#include "fusee/core/folder.h"
#include "fusee/core/process.h"
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

using std::chrono::milliseconds;

constexpr std::size_t kStack = 1 << 18;  // [bytes] of the thread: a limit of memory should not feel it
constexpr milliseconds kAfterHold{300};  // the work ended by itself, most likely
constexpr std::chrono::seconds kLongestHold{20};

volatile std::sig_atomic_t g_signal = 0;
sem_t g_asked;  // the one call of POSIX's that a handler may use to wake a thread
bool g_waiting = false;
int g_grace_of_limit = kGrace_ms;  // [ms] after SIGXCPU: half of what the hard limit leaves when all processors work
std::function<int(int)> g_farewell;

std::shared_timed_mutex& holds() {
    static auto* const one = new std::shared_timed_mutex;  // never destroyed: threads outlive the statics
    return *one;
}

void on_signal(int signal) {
    const int kept = errno;
    if (g_signal != 0 && signal != SIGXCPU) {
        end_processes();
        std::signal(signal, SIG_DFL);
        (void)std::raise(signal);
    }
    if (g_signal == 0) g_signal = signal;
    if (g_waiting) (void)::sem_post(&g_asked);
    errno = kept;
}

/// Waits until no step that belongs together is under way, and lets none begin. After such a step the work may end by itself.
void close_holds() {
    std::unique_lock lock(holds(), std::try_to_lock);
    while (!lock.owns_lock()) {
        if (!lock.try_lock_for(kLongestHold)) return;  // a disk that does not answer
        lock.unlock();
        std::this_thread::sleep_for(kAfterHold);
        (void)lock.try_lock();
    }
    (void)lock.release();
}

/// `ulimit -t` sets both limits, and the hard one kills without a word: the soft one comes earlier, by a second of each processor, for
/// all of them may be at work, but by no more than half of the time.
void warn_before_the_kill() {
    rlimit time{};
    if (::getrlimit(RLIMIT_CPU, &time) != 0 || time.rlim_max == RLIM_INFINITY || time.rlim_max < 2) return;
    const rlim_t processors = std::max(1U, std::thread::hardware_concurrency());
    const rlim_t left_s = std::min(processors, time.rlim_max / 2);
    time.rlim_cur = std::min(time.rlim_cur, time.rlim_max - left_s);
    (void)::setrlimit(RLIMIT_CPU, &time);
    g_grace_of_limit = std::min(kGrace_ms, static_cast<int>(500 * left_s / processors));
}

void* wait_for_signal(void*) {
    while (::sem_wait(&g_asked) != 0) {
    }
    std::this_thread::sleep_for(milliseconds(g_signal == SIGXCPU ? g_grace_of_limit : kGrace_ms));
    close_holds();
    end_processes();
    remove_temporary_folders();
    ::_exit(g_farewell(g_signal));
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

void catch_interrupts() {
    warn_before_the_kill();
    for (const int signal : {SIGINT, SIGTERM, SIGXCPU}) std::signal(signal, on_signal);
    if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // of nohup
    std::signal(SIGXFSZ, SIG_IGN);  // a file above `ulimit -f` is a write that fails: an error as of a full disk
}

bool interrupted() { return g_signal != 0; }

int stop_signal() { return g_signal; }

void end_after_signal(std::function<int(int)> farewell) {
    g_farewell = std::move(farewell);
    pthread_attr_t attributes;
    pthread_t thread{};
    if (::sem_init(&g_asked, 0, 0) != 0 || ::pthread_attr_init(&attributes) != 0) return;
    ::pthread_attr_setstacksize(&attributes, kStack);
    ::pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
    g_waiting = ::pthread_create(&thread, &attributes, wait_for_signal, nullptr) == 0;
    ::pthread_attr_destroy(&attributes);
    if (g_waiting && interrupted()) (void)::sem_post(&g_asked);  // it came before the thread
}

StopHold::StopHold() : lock_(holds()) {}

}  // namespace fusee::core
