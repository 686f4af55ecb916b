#include "fusee/core/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/progress.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks the caller to declare it

namespace fusee::core {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t kTail = 600;  // characters of a program's output in an error
constexpr milliseconds kLook{10};   // interval at which a silent program is polled
constexpr int kPieces = 64;         // of output between two polls of the program

/// Running process groups; 0 is a free place.
std::array<std::atomic<pid_t>, 64> g_groups;
static_assert(std::atomic<pid_t>::is_always_lock_free, "read by a signal handler");

void note_group(pid_t from, pid_t to) {
    for (std::atomic<pid_t>& place : g_groups)
        if (pid_t expected = from; place.compare_exchange_strong(expected, to)) return;
}

/// The environment with one language: some programs stop if a locale is not installed.
std::vector<std::string> plain_environment() {
    std::vector<std::string> all{"LC_ALL=C.UTF-8"};
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text = *entry;
        if (!text.starts_with("LC_") && !text.starts_with("LANG=") && !text.starts_with("LANGUAGE=")) all.push_back(text);
    }
    return all;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> all;
    all.reserve(words.size() + 1);
    for (std::string& word : words) all.push_back(word.data());
    all.push_back(nullptr);
    return all;
}

/// Attributes of a separate process group with default signals.
class Attributes {
public:
    Attributes() {
        ::posix_spawnattr_init(&value_);
        ::posix_spawnattr_setflags(&value_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
        ::posix_spawnattr_setpgroup(&value_, 0);
        sigset_t set;
        ::sigemptyset(&set);
        ::posix_spawnattr_setsigmask(&value_, &set);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGXFSZ, SIGPIPE}) ::sigaddset(&set, signal);
        ::posix_spawnattr_setsigdefault(&value_, &set);
    }
    ~Attributes() { ::posix_spawnattr_destroy(&value_); }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;
    [[nodiscard]] const posix_spawnattr_t* get() const { return &value_; }

private:
    posix_spawnattr_t value_{};
};

/// The words that end the program with fusee, even after kill -9: util-linux's setpriv asks the kernel for that, which posix_spawn cannot.
std::vector<std::string> bound(std::vector<std::string> words) {
    static const bool can = on_path("setpriv");
    const std::string& program = words.front();
    if (!can || (program.find('/') == std::string::npos && !on_path(program))) return words;  // the error names the program
    words.insert(words.begin(), {"setpriv", "--pdeathsig", "KILL", "--"});
    return words;
}

/// Starts a program with `output` as its output. @returns 0 or errno
int spawn(pid_t& pid, std::vector<std::string> words, int output) {
    std::vector<std::string> environment = plain_environment();
    const Attributes attributes;
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    const int failed =
        ::posix_spawnp(&pid, words.front().c_str(), &actions, attributes.get(), pointers(words).data(), pointers(environment).data());
    ::posix_spawn_file_actions_destroy(&actions);
    return failed;
}

/// A child process whose standard output and error can be read; the destructor ends it and its children.
class Child {
public:
    Child(const std::vector<std::string>& words, const std::string& about) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw IoError(about, std::strerror(errno));
        read_ = ends[0];
        const int failed = spawn(pid_, bound(words), ends[1]);
        ::close(ends[1]);
        if (failed == 0) {
            note_group(0, pid_);
            return;
        }
        pid_ = -1;
        ::close(read_);
        const char* why = failed == ENOENT ? "it is not installed, or not on PATH" : std::strerror(failed);
        throw IoError(about, fmt::format("{} cannot be started: {}", words.front(), why));
    }
    ~Child() {
        if (pid_ > 0) (void)end();
        if (read_ >= 0) ::close(read_);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Collects its output until it ends, even if it closes its output. @returns false when the time is up
    bool collect(ProcessResult& result, std::size_t kept, Clock::time_point end) {
        while (true) {
            const bool over = has_ended();  // before the last read of its output
            for (int i = 0; i < kPieces && take(result, kept); ++i) {
            }
            if (over) return true;
            const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
            if (left.count() <= 0) return false;
            if (interrupted()) throw Stopped();
            pollfd waiting{read_, POLLIN, 0};  // a negative descriptor is ignored
            (void)::poll(&waiting, 1, static_cast<int>(std::min(left, kLook).count()));
        }
    }
    /// Ends the rest of its group. @returns its exit code, or -1 if a signal ended it
    int end() {
        ::kill(pid_, SIGKILL);
        ::kill(-pid_, SIGKILL);  // its id stays valid until waitpid
        int status = 0;
        while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        note_group(pid_, 0);
        pid_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    [[nodiscard]] bool has_ended() const {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == pid_;
    }
    /// One piece of output, if there is one now.
    bool take(ProcessResult& result, std::size_t kept) {
        pollfd waiting{read_, POLLIN, 0};
        if (read_ < 0 || ::poll(&waiting, 1, 0) <= 0) return false;
        std::array<char, 65536> buffer;
        const ssize_t got = ::read(read_, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) return true;
        if (got <= 0) {
            ::close(std::exchange(read_, -1));
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

    pid_t pid_ = -1;
    int read_ = -1;
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

void end_processes() noexcept {
    for (const std::atomic<pid_t>& place : g_groups)
        if (const pid_t group = place.load(); group > 0) ::kill(-group, SIGKILL);
}

bool on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

std::string last_words(const std::string& output) { return output.size() > kTail ? "..." + output.substr(output.size() - kTail) : output; }

}  // namespace fusee::core
