#include "fusee/core/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "start_program.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks the caller to declare it

namespace fusee::core {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t kTail = 600;  // characters of a program's output in an error
constexpr milliseconds kLook{10};   // interval at which a silent program is polled
constexpr int kPieces = 64;         // of output between two polls of the program

/// A child process whose standard output and error can be read; the destructor ends it and its children.
class Child {
public:
    Child(const std::vector<std::string>& words, const std::string& about)
        : pipe_(about), pid_(start_program(words, {.output = pipe_.write, .errors = pipe_.write}, about)) {
        pipe_.close_write();
    }
    ~Child() {
        if (pid_ > 0) (void)end();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Collects its output until it ends, even if it closes its output. @returns false when the time is up
    bool collect(ProcessResult& result, std::size_t kept, Clock::time_point end) {
        while (true) {
            const bool over = program_has_ended(pid_);  // before the last read of its output
            for (int i = 0; i < kPieces && take(result, kept); ++i) {
            }
            if (over) return true;
            const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
            if (left.count() <= 0) return false;
            if (interrupted()) throw Stopped();
            pollfd waiting{pipe_.read, POLLIN, 0};  // a negative descriptor is ignored
            (void)::poll(&waiting, 1, static_cast<int>(std::min(left, kLook).count()));
        }
    }
    /// Ends the rest of its group. @returns its exit code, or -1 if a signal ended it
    int end() { return end_program(std::exchange(pid_, -1)); }

private:
    /// One piece of output, if there is one now.
    bool take(ProcessResult& result, std::size_t kept) {
        pollfd waiting{pipe_.read, POLLIN, 0};
        if (pipe_.read < 0 || ::poll(&waiting, 1, 0) <= 0) return false;
        std::array<char, 65536> buffer;
        const ssize_t got = ::read(pipe_.read, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) return true;
        if (got <= 0) {
            pipe_.close_read();
            return false;
        }
        result.output.append(buffer.data(), static_cast<std::size_t>(got));
        if (result.output.size() / 2 > kept) drop(result, kept);
        return true;
    }
    static void drop(ProcessResult& result, std::size_t kept) {
        result.output.erase(0, result.output.size() - kept);
        result.whole = false;
    }

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

ProcessResult run_process(const std::vector<std::string>& words, const std::string& about, std::chrono::seconds timeout, std::size_t kept) {
    Child child(words, about);
    ProcessResult result;
    result.in_time = child.collect(result, kept, Clock::now() + timeout);
    const int code = child.end();
    if (result.in_time) result.code = code;
    if (result.output.size() > kept) {
        result.output.erase(0, result.output.size() - kept);
        result.whole = false;
    }
    return result;
}

bool on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
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
