#include "fusee/core/companion.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/module.h"
#include "fusee/core/process.h"
#include "fusee/core/progress.h"
#include "start_program.h"

namespace fusee::core {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kGlance{20};        // between two looks for a signal
constexpr milliseconds kLastWords{200};    // that a program has to end after it closed its output
constexpr std::size_t kKeptErrors = 4000;  // bytes of standard error

/// write(2) to a program that may have ended: no SIGPIPE reaches fusee.
ssize_t write_quietly(int to, std::string_view bytes) {
    sigset_t pipe, before;
    ::sigemptyset(&pipe);
    ::sigaddset(&pipe, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &pipe, &before);
    const ssize_t sent = ::write(to, bytes.data(), bytes.size());
    const int why = errno;
    const timespec now{0, 0};
    if (sent < 0 && why == EPIPE) (void)::sigtimedwait(&pipe, nullptr, &now);
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    errno = why;
    return sent;
}

/// The file that holds this code: Python's module, else the program. The linker knows the program by its first argument only, which has no
/// folder where the shell found it in PATH.
fs::path own_file() {
    Dl_info self{};
    const bool known = ::dladdr(reinterpret_cast<const void*>(&loaded_function), &self) != 0 && self.dli_fname != nullptr;
    std::error_code ignored;
    return fs::canonical(known && fs::path(self.dli_fname).has_parent_path() ? self.dli_fname : "/proc/self/exe", ignored);
}

/// Where a library of fusee's own may be.
std::vector<fs::path> library_files(const std::string& name) {
    std::vector<fs::path> files;
    if (const fs::path folder = own_file().parent_path(); !folder.empty())
        for (const char* below : {"", "../" FUSEE_LIBDIR "/fusee", "../../" FUSEE_LIBDIR "/fusee"})
            files.push_back((folder / below / name).lexically_normal());
    files.push_back(fs::path(FUSEE_FULL_LIBDIR "/fusee") / name);
    return files;
}

}  // namespace

std::string companion_program(const std::string& name) {
    std::error_code ignored;
    const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / name;
    if (std::filesystem::exists(beside, ignored)) return beside;
    return on_path(name) ? name : "";
}

Companion::Companion(const std::vector<std::string>& words, const std::filesystem::path& folder,
                     const std::vector<std::string>& environment, const std::string& about) {
    Pipe input(about), output(about), errors(about);
    process_ = start_program(words, {input.read, output.write, errors.write, folder, environment}, about);
    input_ = std::exchange(input.write, -1);
    output_ = std::exchange(output.read, -1);
    error_ = std::exchange(errors.read, -1);
    for (const int own : {input_, output_, error_}) (void)::fcntl(own, F_SETFL, O_NONBLOCK);
}

Companion::~Companion() { close_all(); }

void Companion::close_all() {
    if (process_ > 0) code_ = std::max(end_program(std::exchange(process_, -1)), -1);
    listen();
    for (int* end : {&input_, &output_, &error_})
        if (*end >= 0) ::close(std::exchange(*end, -1));
}

/// Sends what fits now. @returns false if the program takes no more for good
bool Companion::send(std::string_view& rest) {
    const ssize_t sent = write_quietly(input_, rest);
    if (sent < 0) return errno == EAGAIN || errno == EINTR;
    rest.remove_prefix(static_cast<std::size_t>(sent));
    return true;
}

/// Takes what it printed. @returns false at the end of its output
bool Companion::receive() {
    std::array<char, 65536> buffer;
    const ssize_t got = ::read(output_, buffer.data(), buffer.size());
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    received_.append(buffer.data(), static_cast<std::size_t>(got));
    return got > 0;
}

/// Takes what it printed to standard error; closes it at its end.
void Companion::listen() {
    std::array<char, 4096> buffer;
    while (error_ >= 0) {
        const ssize_t got = ::read(error_, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return;
        if (got == 0) ::close(std::exchange(error_, -1));
        errors_.append(buffer.data(), static_cast<std::size_t>(got));
        if (errors_.size() > kKeptErrors) errors_.erase(0, errors_.size() - kKeptErrors);
    }
}

Companion::End Companion::ask(std::string_view line, milliseconds timeout, std::string& answer) {
    if (process_ <= 0) return End::kEnded;
    const std::string question = std::string(line) + "\n";
    std::string_view rest = question;
    const auto finish = [this](End end) {
        const Clock::time_point last = Clock::now() + kLastWords;  // of a program that ends: its exit code and its words
        while (end == End::kEnded && !program_has_ended(process_) && Clock::now() < last) (void)::poll(nullptr, 0, 1);
        close_all();
        return end;
    };
    const Clock::time_point end = Clock::now() + timeout;
    std::size_t searched = 0;
    while (true) {
        if (const std::size_t at = received_.find('\n', searched); at != std::string::npos) {
            answer = received_.substr(0, at);
            received_.erase(0, at + 1);
            return End::kAnswered;
        }
        searched = received_.size();
        if (searched > kLongestAnswer) return finish(End::kTooLong);
        const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
        if (left.count() <= 0) return finish(End::kOutOfTime);
        if (interrupted()) throw Stopped();
        std::array<pollfd, 3> waiting{{{output_, POLLIN, 0}, {error_, POLLIN, 0}, {rest.empty() ? -1 : input_, POLLOUT, 0}}};
        (void)::poll(waiting.data(), waiting.size(), static_cast<int>(std::min(left, kGlance).count()));
        listen();
        if (!rest.empty() && waiting[2].revents != 0 && !send(rest)) rest = {};
        if (waiting[0].revents != 0 && !receive()) return finish(End::kEnded);
    }
}

void* loaded_function(const std::string& library, const char* function) {
    std::string reasons;
    for (const fs::path& file : library_files(library)) {
        if (void* loaded = ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL))
            if (void* found = ::dlsym(loaded, function)) return found;
        reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", ::dlerror());
    }
    throw IoError(library, "a library of fusee cannot be loaded: install or build fusee again; tried: " + reasons);
}

}  // namespace fusee::core
