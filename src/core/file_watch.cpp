#include "fusee/core/file_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "fusee/core/error.h"

namespace fusee::core {

namespace {

constexpr std::uint32_t kSaved = IN_CLOSE_WRITE | IN_MOVED_TO | IN_DELETE | IN_MOVED_FROM;

/// Is there something to read within `most`?
bool is_readable(int file, std::chrono::milliseconds most) {
    pollfd waiting{file, POLLIN, 0};
    return ::poll(&waiting, 1, static_cast<int>(most.count())) > 0;
}

}  // namespace

FileWatch::FileWatch() : inotify_(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
    if (inotify_ < 0) throw IoError("inotify", std::strerror(errno));
}

FileWatch::~FileWatch() { ::close(inotify_); }

FileWatch::Target FileWatch::target_of(const fs::path& file) {
    std::error_code error;
    Target target{fs::weakly_canonical(fs::absolute(file), error), {}};
    struct stat folder {
    }, itself{};
    if (::stat(target.place.parent_path().c_str(), &folder) == 0) target.numbers = {folder.st_dev, folder.st_ino, 0, 0};
    if (::stat(target.place.c_str(), &itself) == 0) target.numbers[2] = itself.st_dev, target.numbers[3] = itself.st_ino;
    return target;
}

void FileWatch::watch(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) {
        const fs::path folder = fs::absolute(file).parent_path();
        if (::access(folder.c_str(), R_OK | X_OK) != 0)
            throw IoError(folder.string(), std::string("cannot be watched: ") + std::strerror(errno));
    }
    std::map<fs::path, Target> next;
    for (const fs::path& file : files) {
        const auto known = files_.find(file);  // keeps where it led: a change since the last wait is not lost
        next.emplace(file, known != files_.end() ? known->second : target_of(file));
    }
    files_ = std::move(next);
    attach();
}

/// A folder that is gone is noticed when it is there again.
void FileWatch::attach() {
    std::map<int, std::set<std::string>> now;
    for (const auto& [file, target] : files_) {
        const int folder = ::inotify_add_watch(inotify_, target.place.parent_path().c_str(), kSaved | IN_ONLYDIR);
        if (folder >= 0) now[folder].insert(target.place.filename().string());
        const int itself = ::inotify_add_watch(inotify_, target.place.c_str(), IN_CLOSE_WRITE);  // by another name of the same file
        if (itself >= 0) now[itself].insert("");
    }
    for (const auto& [watch, names] : watched_)
        if (!now.contains(watch)) ::inotify_rm_watch(inotify_, watch);
    watched_ = std::move(now);
}

bool FileWatch::leads_elsewhere() const {
    return std::any_of(files_.begin(), files_.end(), [](const auto& file) { return target_of(file.first) != file.second; });
}

bool FileWatch::take_events() {
    bool ours = false;
    alignas(inotify_event) std::array<char, 16384> buffer;
    for (ssize_t got = 0; (got = ::read(inotify_, buffer.data(), buffer.size())) > 0;) {
        for (ssize_t at = 0; at < got;) {
            inotify_event event;  // NOLINT: filled next; the buffer's objects are read as bytes
            std::memcpy(&event, buffer.data() + at, sizeof event);
            const std::string name = event.len > 0 ? buffer.data() + at + sizeof event : "";
            const auto watched = watched_.find(event.wd);
            if ((event.mask & IN_Q_OVERFLOW) != 0) ours = true;  // events were lost: the file may be among them
            if ((event.mask & IN_IGNORED) == 0 && watched != watched_.end()) ours = ours || watched->second.contains(name);
            at += static_cast<ssize_t>(sizeof event + event.len);
        }
    }
    return ours;
}

bool FileWatch::wait(std::chrono::milliseconds most, std::chrono::milliseconds quiet) {
    const auto end = std::chrono::steady_clock::now() + most;
    for (bool saved = leads_elsewhere(); !saved;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (left.count() <= 0 || !is_readable(inotify_, left)) return false;
        saved = take_events();
    }
    while (is_readable(inotify_, quiet)) (void)take_events();
    if (leads_elsewhere()) {
        for (auto& [file, target] : files_) target = target_of(file);
        attach();
    }
    return true;
}

}  // namespace fusee::core
