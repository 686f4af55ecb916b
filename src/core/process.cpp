#include "fusee/core/process.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "start_program.h"

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

std::string last_words(const std::string& output) { return output.size() > kTail ? "..." + output.substr(output.size() - kTail) : output; }

}  // namespace fusee::core
