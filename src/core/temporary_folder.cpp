#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>
#include <system_error>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/folder.h"

namespace fusee::core {

namespace {

constexpr std::size_t kRandom = 6;  // characters that mkdtemp chooses

/// The folders of this process, for an end without destructors.
struct Living {
    std::mutex mutex;
    std::set<fs::path> whole, if_empty;
};
Living& living() {
    static auto* const one = new Living;  // outlives the statics, as threads do
    return *one;
}

Descriptor open_folder(const fs::path& folder) {
    return Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW));
}

bool try_lock(const Descriptor& folder) { return folder && ::flock(folder.get(), LOCK_EX | LOCK_NB) == 0; }

/// Does the folder still have this name?
bool has_name(const Descriptor& folder, const fs::path& name) {
    struct stat open {
    }, named{};
    return ::fstat(folder.get(), &open) == 0 && ::lstat(name.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

/// Was it made by mkdtemp for this user? A folder that a user makes lets others in.
bool is_private(const Descriptor& folder) {
    struct stat open {};
    return ::fstat(folder.get(), &open) == 0 && open.st_uid == ::geteuid() && (open.st_mode & (S_IRWXG | S_IRWXO)) == 0;
}

}  // namespace

bool is_temporary_name(const std::string& name, const std::string& prefix) {
    if (name.size() != prefix.size() + kRandom || !name.starts_with(prefix)) return false;
    const auto chosen = [](unsigned char c) { return c < 0x80 && std::isalnum(c) != 0; };
    return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()), name.end(), chosen);
}

bool is_in_temporary_folder(const fs::path& path) {
    const fs::path folder = path.parent_path();
    return std::any_of(folder.begin(), folder.end(), [](const fs::path& part) {
        return is_temporary_name(part.string(), kStagingPrefix) || is_temporary_name(part.string(), kTemporaryPrefix);
    });
}

void remove_left_behind(const fs::path& parent, const std::string& prefix) {
    std::error_code ignored;
    std::vector<fs::path> found;
    for (auto entry = fs::directory_iterator(parent, ignored); !ignored && entry != fs::directory_iterator(); entry.increment(ignored))
        if (is_temporary_name(entry->path().filename().string(), prefix)) found.push_back(entry->path());
    for (const fs::path& folder : found) {
        const Descriptor open = open_folder(folder);
        if (try_lock(open) && is_private(open) && has_name(open, folder)) fs::remove_all(folder, ignored);
    }
}

TemporaryFolder::TemporaryFolder(const fs::path& parent, const std::string& prefix) { make(parent, prefix); }

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);  // fails if TMPDIR is not a folder
    const char* named = std::getenv("TMPDIR");
    if (error) throw IoError(fmt::format("TMPDIR={}", named == nullptr ? "" : named), "no folder for temporary files: " + error.message());
    make(fs::canonical(parent), kTemporaryPrefix);
}

void TemporaryFolder::make(const fs::path& parent, const std::string& prefix) {
    remove_left_behind(parent, prefix);
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
        std::string pattern = (parent / (prefix + std::string(kRandom, 'X'))).string();
        if (::mkdtemp(pattern.data()) == nullptr)
            throw IoError(parent.string(), fmt::format("no folder for temporary files can be created here: {}", std::strerror(errno)));
        Descriptor open = open_folder(pattern);
        // Before it is locked, another process may remove it as one left behind. A file system without locks is accepted.
        if ((!try_lock(open) && errno == EWOULDBLOCK) || !has_name(open, pattern)) continue;
        path_ = pattern;
        lock_ = open.release();
        const std::scoped_lock lock(living().mutex);
        living().whole.insert(path_);
        return;
    }
    throw IoError(parent.string(), "no folder for temporary files can be created here: another process removes it");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    {
        const Descriptor open(lock_);
        if (has_name(open, path_)) fs::remove_all(path_, ignored);  // another folder may have its name now
    }
    const std::scoped_lock lock(living().mutex);
    living().whole.erase(path_);
}

NewFolder::NewFolder(const fs::path& place, const fs::path& shown)
    : path_(place), is_new_(!OpenFolder::find(place, shown)), folder_(OpenFolder::make(place, shown)) {
    const std::scoped_lock lock(living().mutex);
    if (is_new_) living().if_empty.insert(path_);
}

NewFolder::~NewFolder() {
    if (!is_new_) return;
    (void)::rmdir(path_.c_str());  // fails unless it is an empty folder
    const std::scoped_lock lock(living().mutex);
    living().if_empty.erase(path_);
}

void remove_temporary_folders() {
    constexpr int kTries = 3;  // another thread may write there still
    std::error_code ignored;
    const std::scoped_lock lock(living().mutex);
    for (int i = 0; i < kTries; ++i)
        for (const fs::path& folder : living().whole) fs::remove_all(folder, ignored);
    for (const fs::path& folder : living().if_empty) (void)::rmdir(folder.c_str());
}

}  // namespace fusee::core
