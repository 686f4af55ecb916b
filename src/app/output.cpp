#include "output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>

#include "exit_codes.h"
#include "fusee/core/terminal.h"

namespace fusee::app {

namespace {

int g_failed = 0;  ///< errno of the first write to standard output that failed

void note(bool good) {
    if (!good && g_failed == 0) g_failed = errno != 0 ? errno : EIO;
}

}  // namespace

void keep_standard_files() {
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(file, F_GETFD) < 0) (void)::open("/dev/null", O_RDONLY);  // takes the lowest free number; writing to it fails
}

void print_out(std::string_view text) {
    if (g_failed != 0) return;
    errno = 0;
    note(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

std::size_t columns_out() { return core::is_terminal(STDOUT_FILENO) ? core::terminal_columns() : std::numeric_limits<std::size_t>::max(); }

bool is_output_open() { return g_failed == 0; }

bool flush_out() {
    errno = 0;
    if (g_failed == 0) note(std::fflush(stdout) == 0);
    return g_failed == 0;
}

int close_out(int code) {
    if (flush_out() || g_failed == EPIPE) return code;
    core::say_error(
        fmt::format("fusee: standard output cannot be written: {}\n", g_failed == EBADF ? "it is closed" : std::strerror(g_failed)));
    return std::max(code, kBadInput);
}

void put_without_waiting(int file, std::string_view text) noexcept {
    pollfd ready{file, POLLOUT, 0};  // a pipe that is ready takes PIPE_BUF bytes at once
    if (::poll(&ready, 1, 0) > 0 && (ready.revents & POLLOUT) != 0)
        (void)!::write(file, text.data(), std::min<std::size_t>(text.size(), 4096));
}

}  // namespace fusee::app
