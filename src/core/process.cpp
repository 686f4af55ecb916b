#include "fusee/core/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
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

#include "fusee/core/error.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks the caller to declare it

namespace fusee::core {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kTail = 600;  // characters of a program's own words that go into an error

/// A child process whose standard output and error can be read; ended if still running when this goes.
class Child {
public:
    Child(const std::vector<std::string>& words, const std::string& about) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw IoError(about, std::strerror(errno));
        read_ = ends[0];
        posix_spawn_file_actions_t actions;
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
        std::vector<char*> arguments;
        arguments.reserve(words.size() + 1);
        for (const std::string& w : words) arguments.push_back(const_cast<char*>(w.c_str()));
        arguments.push_back(nullptr);
        const int failed = ::posix_spawnp(&pid_, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
        ::posix_spawn_file_actions_destroy(&actions);
        ::close(ends[1]);
        if (failed == 0) return;
        pid_ = -1;
        ::close(read_);
        throw IoError(about, fmt::format("{} cannot be started: {}", words.front(), std::strerror(failed)));
    }
    ~Child() {
        if (pid_ > 0) {
            ::kill(pid_, SIGKILL);
            (void)wait();
        }
        ::close(read_);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// All that it prints until it closes its output; nothing more after `end`. @returns false when the time is up
    bool collect(std::string& output, Clock::time_point end) const {
        std::array<char, 65536> buffer{};
        while (true) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
            if (left <= 0) return false;
            pollfd waiting{read_, POLLIN, 0};
            const int ready = ::poll(&waiting, 1, static_cast<int>(std::min<long long>(left, 1000)));
            if (ready <= 0) continue;
            const ssize_t got = ::read(read_, buffer.data(), buffer.size());
            if (got == 0 || (got < 0 && errno != EINTR)) return true;
            if (got > 0) output.append(buffer.data(), static_cast<std::size_t>(got));
        }
    }
    /// Its exit code, or -1 if a signal ended it.
    int wait() {
        int status = 0;
        while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t pid_ = -1;
    int read_ = -1;
};

}  // namespace

ProcessResult run_process(const std::vector<std::string>& words, const std::string& about, std::chrono::seconds timeout) {
    Child child(words, about);
    ProcessResult result;
    result.in_time = child.collect(result.output, Clock::now() + timeout);
    if (result.in_time) result.code = child.wait();
    return result;
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
