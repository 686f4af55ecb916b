#include "fusee/core/temporary_folder.h"

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
#include <utility>
#include <vector>

#include "fusee/core/destination.h"
#include "fusee/core/error.h"

namespace fs = std::filesystem;

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

/// An open folder, closed by the destructor.
class Descriptor {
public:
    explicit Descriptor(const fs::path& folder) : value_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW)) {}
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] bool lock() const { return value_ >= 0 && ::flock(value_, LOCK_EX | LOCK_NB) == 0; }
    [[nodiscard]] bool is(const fs::path& folder) const {
        struct stat open {
        }, named{};
        return ::fstat(value_, &open) == 0 && ::lstat(folder.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
               open.st_ino == named.st_ino;
    }
    [[nodiscard]] int release() { return std::exchange(value_, -1); }

private:
    int value_;
};

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
        const Descriptor open(folder);
        if (open.lock()) fs::remove_all(folder, ignored);
    }
}

TemporaryFolder::TemporaryFolder(const fs::path& parent, const std::string& prefix) { make(parent, prefix); }

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);  // fails if TMPDIR is not a folder
    const char* named = std::getenv("TMPDIR");
    if (error) throw IoError(fmt::format("TMPDIR={}", named == nullptr ? "" : named), "no folder for temporary files: " + error.message());
    make(parent, kTemporaryPrefix);
}

void TemporaryFolder::make(const fs::path& parent, const std::string& prefix) {
    remove_left_behind(parent, prefix);
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
        std::string pattern = (parent / (prefix + std::string(kRandom, 'X'))).string();
        if (::mkdtemp(pattern.data()) == nullptr)
            throw IoError(parent.string(), fmt::format("no folder for temporary files can be created here: {}", std::strerror(errno)));
        Descriptor open(pattern);
        // Before it is locked, another process may remove it as one left behind. A file system without locks is accepted.
        if ((!open.lock() && errno == EWOULDBLOCK) || !open.is(pattern)) continue;
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
    fs::remove_all(path_, ignored);
    if (lock_ >= 0) ::close(lock_);
    const std::scoped_lock lock(living().mutex);
    living().whole.erase(path_);
}

NewFolder::NewFolder(const fs::path& place) : path_(place) {
    std::error_code ignored;
    is_new_ = !fs::exists(place, ignored);
    make_folder(place);
    const std::scoped_lock lock(living().mutex);
    if (is_new_) living().if_empty.insert(path_);
}

NewFolder::~NewFolder() {
    if (!is_new_) return;
    std::error_code ignored;
    fs::remove(path_, ignored);  // fails unless it is empty
    const std::scoped_lock lock(living().mutex);
    living().if_empty.erase(path_);
}

void remove_temporary_folders() {
    constexpr int kTries = 3;  // another thread may write there still
    std::error_code ignored;
    const std::scoped_lock lock(living().mutex);
    for (int i = 0; i < kTries; ++i)
        for (const fs::path& folder : living().whole) fs::remove_all(folder, ignored);
    for (const fs::path& folder : living().if_empty) fs::remove(folder, ignored);
}

}  // namespace fusee::core
