#include "fusee/core/process.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/core/progress.h"
#include "start_program.h"

namespace fusee::core {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t kTail = 600;  // characters of a program's output in an error
constexpr milliseconds kLook{10};   // interval at which a silent program is polled
constexpr int kPieces = 64;         // of output between two polls of the program

/// A child process whose output can be read; the destructor ends it and its children.
class Child {
public:
    /// @param errors descriptor of its standard error; kWithOutput: it comes with its output @param bound as of Ends
    Child(const std::vector<std::string>& words, const std::string& about, int errors = kWithOutput, bool bound = true)
        : pipe_(about),
          pid_(start_program(words, {.output = pipe_.write, .errors = errors == kWithOutput ? pipe_.write : errors, .bound = bound},
                             about)) {
        pipe_.close_write();
    }
    ~Child() {
        if (pid_ > 0) (void)end();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Takes each piece of its output until it ends, even if it closes its output. @returns false when the time is up, or if `take` is
    template <class Take>
    bool collect(const Take& take, Clock::time_point end) {
        while (true) {
            const bool over = program_has_ended(pid_);  // before the last read of its output
            std::string piece;
            for (int i = 0; i < kPieces && read(piece); ++i)
                if (!take(piece)) return false;
            if (over) return true;
            const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
            if (left.count() <= 0) return false;
            if (interrupted()) throw Stopped();
            pollfd waiting{pipe_.read, POLLIN, 0};  // a negative descriptor is ignored
            (void)::poll(&waiting, 1, static_cast<int>(std::min(left, kLook).count()));
        }
    }
    /// Ends the rest of its group. @returns as end_program
    int end() { return end_program(std::exchange(pid_, -1)); }

private:
    /// @returns whether there is output now, or may be
    bool read(std::string& piece) {
        pollfd waiting{pipe_.read, POLLIN, 0};
        if (pipe_.read < 0 || ::poll(&waiting, 1, 0) <= 0) return false;
        piece.resize(65536);
        const ssize_t got = ::read(pipe_.read, piece.data(), piece.size());
        piece.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        if (got == 0 || (got < 0 && errno != EINTR)) pipe_.close_read();
        return pipe_.read >= 0;
    }

    static constexpr int kWithOutput = -2;
    Pipe pipe_;
    pid_t pid_;
};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
constexpr bool kSanitized = true;  // it reserves terabytes of address space
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

void limit(int resource, rlim_t soft, rlim_t hard) {
    rlimit now{};
    ::getrlimit(static_cast<__rlimit_resource_t>(resource), &now);
    now.rlim_max = std::min(now.rlim_max, hard);
    now.rlim_cur = std::min({now.rlim_cur, soft, now.rlim_max});
    ::setrlimit(static_cast<__rlimit_resource_t>(resource), &now);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& words, const std::string& about, std::chrono::seconds timeout, std::size_t kept) {
    Child child(words, about);
    ProcessResult result;
    const auto drop = [&](std::size_t beyond) {
        if (result.output.size() <= beyond) return;
        result.output.erase(0, result.output.size() - kept);
        result.whole = false;
    };
    const auto take = [&](const std::string& piece) {
        result.output += piece;
        drop(2 * kept);
        return true;
    };
    result.in_time = child.collect(take, Clock::now() + timeout);
    const int code = child.end();
    if (result.in_time) result.code = std::max(code, -1);
    drop(kept);
    return result;
}

bool on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    for (const std::string_view folder : pieces_of(path == nullptr ? "" : path, ":"))
        if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

std::string last_words(const std::string& output) {
    const std::string text = output.substr(0, output.find_last_not_of(" \t\r\n") + 1);
    return text.size() > kTail ? "..." + text.substr(text.size() - kTail) : text;
}

void open_no_more_files() {
    if (kSanitized) return;
    limit(RLIMIT_NOFILE, 0, 0);
    limit(RLIMIT_FSIZE, 0, 0);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
}

void limit_this_process(const ChildLimits& limits) {
    const auto seconds = static_cast<rlim_t>(limits.time.count());
    limit(RLIMIT_CPU, seconds, seconds + 1);
    limit(RLIMIT_CORE, 0, 0);
    if (!kSanitized) limit(RLIMIT_AS, limits.memory_bytes, limits.memory_bytes);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
}

ChildResult run_child(const std::vector<std::string>& words, const std::string& about, const ChildLimits& limits) {
    using End = ChildResult::End;
    Child child(words, about, kSanitized ? STDERR_FILENO : -1, false);  // not bound: it asks for that by itself (limit_this_process)
    ChildResult result;
    const auto take = [&](const std::string& piece) {
        if (result.output.size() + piece.size() > limits.output_bytes) result.end = End::kTooMuchOutput;
        if (result.end == End::kExited) result.output += piece;
        return result.end == End::kExited;
    };
    const bool ended = child.collect(take, Clock::now() + limits.clock);
    const int code = child.end();
    if (result.end == End::kTooMuchOutput) return result;
    result.code = std::abs(code);
    if (!ended || code == -SIGXCPU)
        result.end = End::kOutOfTime;
    else if (code < 0)
        result.end = End::kSignalled;
    return result;
}

}  // namespace fusee::core
