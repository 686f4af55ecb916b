#include "fusee/exchange/openscad.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <vector>

#include "fusee/core/error.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks the caller to declare it

namespace fusee::exchange {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kTail = 600;  // characters of openscad's own words that go into an error

/// A child process whose standard output and error can be read; ended if still running when this goes.
class Child {
public:
    Child(const std::vector<std::string>& words, const std::string& about) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw core::IoError(about, std::strerror(errno));
        read_ = ends[0];
        posix_spawn_file_actions_t actions;
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
        std::vector<char*> arguments;
        for (const std::string& w : words) arguments.push_back(const_cast<char*>(w.c_str()));
        arguments.push_back(nullptr);
        const int failed = ::posix_spawnp(&pid_, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
        ::posix_spawn_file_actions_destroy(&actions);
        ::close(ends[1]);
        if (failed == 0) return;
        pid_ = -1;
        ::close(read_);
        throw core::IoError(about, fmt::format("{} cannot be started: {}", words.front(), std::strerror(failed)));
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
        std::array<char, 4096> buffer{};
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

void render_scad(const fs::path& scad, const fs::path& stl, std::chrono::seconds timeout) {
    const std::string about = scad.string();
    const fs::path temporary = stl.parent_path() / fmt::format(".{}.render-{}", stl.filename().string(), ::getpid());
    // A file name that begins with a dash would be read as an option.
    const auto name = [](const fs::path& p) { return fs::absolute(p).string(); };
    std::string output;
    int code = 0;
    bool in_time = true;
    {
        Child child({"openscad", "--hardwarnings", "--export-format", "binstl", "-o", name(temporary), name(scad)}, about);
        in_time = child.collect(output, Clock::now() + timeout);
        if (in_time) code = child.wait();
    }
    std::error_code error;
    if (in_time && code == 0) {
        fs::rename(temporary, stl, error);
        if (error) throw core::IoError(stl.string(), error.message());
        return;
    }
    fs::remove(temporary, error);
    if (!in_time) throw core::IoError(about, fmt::format("openscad was still running after {} s", timeout.count()));
    const std::string tail = output.size() > kTail ? "..." + output.substr(output.size() - kTail) : output;
    throw core::IoError(about, fmt::format("openscad ended with {}: {}", code, tail));
}

}  // namespace fusee::exchange
