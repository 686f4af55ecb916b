#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "fusee/core/error.h"
#include "fusee/core/process.h"
#include "fusee/core/progress.h"
#include "start_program.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks the caller to declare it

namespace fusee::core {

namespace {

using Clock = std::chrono::steady_clock;

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

/// A running child whose standard output can be read; the destructor kills it if it still runs.
class Spawned {
public:
    Spawned(const std::vector<std::string>& words, const std::string& about) : pipe_(about) {
        posix_spawn_file_actions_t actions;
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&actions, pipe_.write, STDOUT_FILENO);
        if (!kSanitized) ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        std::vector<char*> arguments;
        arguments.reserve(words.size() + 1);
        for (const std::string& w : words) arguments.push_back(const_cast<char*>(w.c_str()));
        arguments.push_back(nullptr);
        const int failed = ::posix_spawn(&pid_, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
        ::posix_spawn_file_actions_destroy(&actions);
        pipe_.close_write();
        if (failed != 0) throw IoError(about, fmt::format("the process that reads it cannot be started: {}", std::strerror(failed)));
    }
    ~Spawned() {
        if (pid_ > 0) (void)ended(true);
    }
    Spawned(const Spawned&) = delete;
    Spawned& operator=(const Spawned&) = delete;

    /// Reads its output until it is closed. @returns the reason to kill it, or kExited
    ChildResult::End collect(std::string& output, const ChildLimits& limits, Clock::time_point end) const {
        std::vector<char> buffer(1 << 20);
        while (Clock::now() < end) {
            if (interrupted()) throw Stopped();
            pollfd waiting{pipe_.read, POLLIN, 0};
            if (::poll(&waiting, 1, kTick_ms) <= 0) continue;
            const ssize_t got = ::read(pipe_.read, buffer.data(), buffer.size());
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return ChildResult::End::kExited;
            if (output.size() + static_cast<std::size_t>(got) > limits.output_bytes) return ChildResult::End::kTooMuchOutput;
            output.append(buffer.data(), static_cast<std::size_t>(got));
        }
        return ChildResult::End::kOutOfTime;
    }
    /// Waits until `end` for its end, even if it closed its output. @returns its status; -1: still running
    int wait_until(Clock::time_point end) {
        while (Clock::now() < end) {
            if (interrupted()) throw Stopped();
            int status = 0;
            const pid_t which = ::waitpid(pid_, &status, WNOHANG);
            if (which == pid_) return pid_ = -1, status;
            if (which < 0 && errno != EINTR) return pid_ = -1, 0;
            ::poll(nullptr, 0, 1);
        }
        return -1;
    }
    /// Its status. @param kill it first
    int ended(bool kill) {
        int status = 0;
        if (kill) ::kill(pid_, SIGKILL);
        while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        return status;
    }

private:
    static constexpr int kTick_ms = 100;
    Pipe pipe_;
    pid_t pid_ = -1;
};

}  // namespace

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
    const Clock::time_point end = Clock::now() + limits.clock;
    Spawned child(words, about);
    ChildResult result;
    result.end = child.collect(result.output, limits, end);
    if (result.end != ChildResult::End::kExited) return result;
    const int status = child.wait_until(end);
    if (status == -1) {
        result.end = ChildResult::End::kOutOfTime;
    } else if (WIFSIGNALED(status)) {
        result.code = WTERMSIG(status);
        result.end = result.code == SIGXCPU ? ChildResult::End::kOutOfTime : ChildResult::End::kSignalled;
    } else {
        result.code = WEXITSTATUS(status);
    }
    return result;
}

}  // namespace fusee::core
