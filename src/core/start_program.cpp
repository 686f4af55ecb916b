#include "start_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/process.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks the caller to declare it

namespace fusee::core {

namespace {

/// Running process groups; 0 is a free place.
std::array<std::atomic<pid_t>, 64> g_groups;
static_assert(std::atomic<pid_t>::is_always_lock_free, "read by a signal handler");

void note_group(pid_t from, pid_t to) {
    for (std::atomic<pid_t>& place : g_groups)
        if (pid_t expected = from; place.compare_exchange_strong(expected, to)) return;
}

/// The environment with one language: some programs stop if a locale is not installed.
std::vector<std::string> plain_environment(const std::vector<std::string>& more) {
    std::vector<std::string> all = more;
    all.emplace_back("LC_ALL=C.UTF-8");
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

/// @returns 0 or errno
int spawn(pid_t& pid, std::vector<std::string> words, const Ends& ends) {
    std::vector<std::string> environment = plain_environment(ends.environment);
    const Attributes attributes;
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    if (ends.input < 0)
        ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    else
        ::posix_spawn_file_actions_adddup2(&actions, ends.input, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, ends.output, STDOUT_FILENO);
    if (ends.errors < 0)
        ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    else
        ::posix_spawn_file_actions_adddup2(&actions, ends.errors, STDERR_FILENO);
    if (!ends.folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions, ends.folder.c_str());
    const int failed =
        ::posix_spawnp(&pid, words.front().c_str(), &actions, attributes.get(), pointers(words).data(), pointers(environment).data());
    ::posix_spawn_file_actions_destroy(&actions);
    return failed;
}

}  // namespace

Pipe::Pipe(const std::string& about) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw IoError(about, std::strerror(errno));
    read = ends[0], write = ends[1];
}

void Pipe::close(int& end) {
    if (end >= 0) ::close(std::exchange(end, -1));
}

pid_t start_program(std::vector<std::string> words, const Ends& ends, const std::string& about) {
    const std::string name = words.front();
    pid_t pid = -1;
    const int failed = spawn(pid, ends.bound ? bound(std::move(words)) : std::move(words), ends);
    if (failed == 0) {
        note_group(0, pid);
        return pid;
    }
    const char* why = failed == ENOENT ? "it is not installed, or not on PATH" : std::strerror(failed);
    throw IoError(about, fmt::format("{} cannot be started: {}", name, why));
}

bool program_has_ended(pid_t program) {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(program), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == program;
}

int end_program(pid_t program) {
    ::kill(program, SIGKILL);
    ::kill(-program, SIGKILL);  // its id stays valid until waitpid
    int status = 0;
    while (::waitpid(program, &status, 0) < 0 && errno == EINTR) {
    }
    note_group(program, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

void end_processes() noexcept {
    for (const std::atomic<pid_t>& place : g_groups)
        if (const pid_t group = place.load(); group > 0) ::kill(-group, SIGKILL);
}

}  // namespace fusee::core
