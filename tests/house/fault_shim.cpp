// LD_PRELOAD: lets one call of the C library fail, as a disk, a system limit or a fault of fusee would (tests/house/faults.sh).
// FUSEE_FAULT=CALL:ERROR:N: the N-th call of fsync, write, rename, open, mkdir, spawn or malloc and all later ones fail with this number of
// errno; malloc ones above 1 MB are counted. ERROR "throw" lets fsync throw an exception that no caller expects;
// "stop" lets the N-th fsync stop the process (SIGSTOP), so that a signal that is sent then finds it at work.
// FUSEE_COUNT=FILE: each process appends the number of its calls of malloc, a line each (tests/bench/cost.py).
#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace {

struct Fault {
    char call[16] = "";
    int error = 0;
    long first = 0;
    bool throws = false, stops = false;
    std::atomic<long> calls = 0;
    Fault() {
        const char* text = std::getenv("FUSEE_FAULT");
        char error_text[16] = "";
        if (text == nullptr || std::sscanf(text, "%15[^:]:%15[^:]:%ld", call, error_text, &first) != 3) return;
        throws = std::strcmp(error_text, "throw") == 0;
        stops = std::strcmp(error_text, "stop") == 0;
        error = std::atoi(error_text);
    }
    bool hits(const char* name) { return std::strcmp(call, name) == 0 && ++calls >= first; }
};

Fault& fault() {
    static Fault* const one = new Fault;
    return *one;
}

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

std::atomic<long> allocations = 0;

[[gnu::destructor]] void append_count() {
    const char* name = std::getenv("FUSEE_COUNT");
    std::FILE* file = name != nullptr ? std::fopen(name, "ae") : nullptr;
    if (file == nullptr) return;
    std::fprintf(file, "%ld\n", allocations.load());
    std::fclose(file);
}

/// Is it a file of a run, and not one that the program needs to begin?
bool is_output(int file) {
    struct stat about {};
    return file > 2 && ::fstat(file, &about) == 0 && S_ISREG(about.st_mode);
}

}  // namespace

extern "C" {

int fsync(int file) {
    static const auto call = next<int (*)(int)>("fsync");
    if (!fault().hits("fsync")) return call(file);
    if (fault().stops) return fault().calls == fault().first ? std::raise(SIGSTOP) : 0, call(file);
    if (fault().throws) throw std::logic_error("injected by the test");
    return errno = fault().error, -1;
}

ssize_t write(int file, const void* bytes, size_t count) {
    static const auto call = next<ssize_t (*)(int, const void*, size_t)>("write");
    if (is_output(file) && fault().hits("write")) return errno = fault().error, -1;
    return call(file, bytes, count);
}

int rename(const char* from, const char* to) noexcept {
    static const auto call = next<int (*)(const char*, const char*)>("rename");
    if (fault().hits("rename")) return errno = fault().error, -1;
    return call(from, to);
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
    static const auto call = next<int (*)(int, const char*, int, const char*)>("renameat");
    if (fault().hits("rename")) return errno = fault().error, -1;
    return call(from_folder, from, to_folder, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) noexcept {
    static const auto call = next<int (*)(int, const char*, int, const char*, unsigned)>("renameat2");
    if (fault().hits("rename")) return errno = fault().error, -1;
    return call(from_folder, from, to_folder, to, flags);
}

int mkdirat(int folder, const char* path, mode_t mode) noexcept {
    static const auto call = next<int (*)(int, const char*, mode_t)>("mkdirat");
    if (fault().hits("mkdir")) return errno = fault().error, -1;
    return call(folder, path, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    static const auto call = next<int (*)(int, const char*, int, ...)>("openat");
    va_list rest;
    va_start(rest, flags);
    const auto mode = (flags & O_CREAT) != 0 ? va_arg(rest, unsigned) : 0U;
    va_end(rest);
    if ((flags & O_CREAT) != 0 && fault().hits("open")) return errno = fault().error, -1;
    return call(folder, path, flags, mode);
}

int mkdir(const char* path, mode_t mode) noexcept {
    static const auto call = next<int (*)(const char*, mode_t)>("mkdir");
    if (fault().hits("mkdir")) return errno = fault().error, -1;
    return call(path, mode);
}

int open(const char* path, int flags, ...) {
    static const auto call = next<int (*)(const char*, int, ...)>("open");
    va_list rest;
    va_start(rest, flags);
    const auto mode = (flags & O_CREAT) != 0 ? va_arg(rest, unsigned) : 0U;
    va_end(rest);
    if ((flags & O_CREAT) != 0 && fault().hits("open")) return errno = fault().error, -1;
    return call(path, flags, mode);
}

int posix_spawn(pid_t* pid, const char* path, const posix_spawn_file_actions_t* actions, const posix_spawnattr_t* attributes,
                char* const arguments[], char* const environment[]) {
    using Spawn = int (*)(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*, char* const[], char* const[]);
    static const auto call = next<Spawn>("posix_spawn");
    if (fault().hits("spawn")) return fault().error;
    return call(pid, path, actions, attributes, arguments, environment);
}

int posix_spawnp(pid_t* pid, const char* path, const posix_spawn_file_actions_t* actions, const posix_spawnattr_t* attributes,
                 char* const arguments[], char* const environment[]) {
    using Spawn = int (*)(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*, char* const[], char* const[]);
    static const auto call = next<Spawn>("posix_spawnp");
    if (fault().hits("spawn")) return fault().error;
    return call(pid, path, actions, attributes, arguments, environment);
}

void* malloc(size_t size) noexcept {
    constexpr size_t kLarge = 1'000'000;
    static std::atomic<void* (*)(size_t)> call{nullptr};
    if (call.load() == nullptr) call = next<void* (*)(size_t)>("malloc");
    ++allocations;
    if (size > kLarge && fault().hits("malloc")) return errno = ENOMEM, nullptr;
    return call.load()(size);
}

}  // extern "C"
