#include "fusee/core/file_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
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

void FileWatch::watch(const std::vector<std::filesystem::path>& files) {
    std::map<std::filesystem::path, std::set<std::string>> names;
    for (const std::filesystem::path& file : files) {
        const std::filesystem::path place = std::filesystem::absolute(file);
        names[place.parent_path()].insert(place.filename().string());
    }
    for (const auto& [folder, wanted] : names) {
        if (names_.contains(folder)) continue;
        const int watched = ::inotify_add_watch(inotify_, folder.c_str(), kSaved | IN_ONLYDIR);
        if (watched < 0) throw IoError(folder.string(), std::string("cannot be watched: ") + std::strerror(errno));
        folders_[watched] = folder;
    }
    std::erase_if(folders_, [&](const auto& entry) {
        const bool needless = !names.contains(entry.second);
        if (needless) ::inotify_rm_watch(inotify_, entry.first);
        return needless;
    });
    names_ = std::move(names);
}

bool FileWatch::take_events() {
    bool ours = false;
    alignas(inotify_event) std::array<char, 16384> buffer;
    for (ssize_t got = 0; (got = ::read(inotify_, buffer.data(), buffer.size())) > 0;) {
        for (ssize_t at = 0; at < got;) {
            inotify_event event;  // NOLINT: filled next; the buffer's objects are read as bytes
            std::memcpy(&event, buffer.data() + at, sizeof event);
            const auto folder = folders_.find(event.wd);
            if ((event.mask & IN_Q_OVERFLOW) != 0) ours = true;  // events were lost: the file may be among them
            if (folder != folders_.end() && event.len > 0)
                ours = ours || names_.at(folder->second).contains(buffer.data() + at + sizeof event);
            at += static_cast<ssize_t>(sizeof event + event.len);
        }
    }
    return ours;
}

bool FileWatch::wait(std::chrono::milliseconds most, std::chrono::milliseconds quiet) {
    const auto end = std::chrono::steady_clock::now() + most;
    bool saved = false;
    while (!saved) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (left.count() <= 0 || !is_readable(inotify_, left)) return false;
        saved = take_events();
    }
    while (is_readable(inotify_, quiet)) (void)take_events();
    return true;
}

}  // namespace fusee::core
