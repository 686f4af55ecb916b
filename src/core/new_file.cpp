#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"
#include "fusee/core/resource_error.h"
#include "fusee/core/text.h"

namespace fusee::core {

namespace {

constexpr int kNames = 1000;  // tried for a temporary file

/// The folder of a file to write. A staging folder's path has no links: one that is there now was put there while fusee ran.
OpenFolder folder_of(const fs::path& file) {
    const fs::path folder = file.parent_path();
    std::error_code ignored;
    const auto is_staging = [](const fs::path& part) { return is_temporary_name(part.string(), kStagingPrefix); };
    try {
        const bool is_named = std::none_of(folder.begin(), folder.end(), is_staging);
        if (is_named && (folder.empty() || fs::exists(folder, ignored))) return OpenFolder::named(folder);
        if (auto found = is_named ? std::nullopt : OpenFolder::find(folder, folder)) return std::move(*found);
    } catch (const IoError& e) {
        throw IoError(file.string(), std::string("cannot be written: ") + e.what());
    }
    throw IoError(file.string(), std::string("cannot be written: ") + std::strerror(ENOENT));
}

/// Removes what killed processes left in `write_file`.
void remove_parts(const fs::path& file) {
    const std::string prefix = "." + file.filename().string() + ".part-";
    std::error_code ignored;
    std::vector<fs::path> parts;
    for (auto entry = fs::directory_iterator(file.has_parent_path() ? file.parent_path() : ".", ignored);
         !ignored && entry != fs::directory_iterator(); entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        int process = 0, serial = 0, end = 0;
        if (!name.starts_with(prefix) || std::sscanf(name.c_str() + prefix.size(), "%d-%d%n", &process, &serial, &end) != 2) continue;
        if (prefix.size() + static_cast<std::size_t>(end) != name.size() || !fs::is_regular_file(entry->symlink_status(ignored))) continue;
        if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) parts.push_back(entry->path());
    }
    for (const fs::path& part : parts) fs::remove(part, ignored);
}

}  // namespace

int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(count));
        else if (errno != EINTR)
            return errno;
    }
    return 0;
}

NewFile::NewFile(fs::path path) : path_(std::move(path)), folder_(folder_of(path_)) {
    require_plain_name(path_);
    static std::atomic<unsigned> serial{0};
    for (int i = 0; i < kNames && !file_; ++i) {  // a name may have been left by a killed process
        temporary_ = fmt::format(".{}.part-{}-{}", path_.filename().string(), ::getpid(), serial++);
        file_ = Descriptor(::openat(folder_.get(), temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
        if (!file_ && errno != EEXIST) break;
    }
    if (!file_) require(errno);
}

NewFile::~NewFile() {
    if (file_ && !temporary_.empty()) (void)::unlinkat(folder_.get(), temporary_.c_str(), 0);
}

void NewFile::require(int error) const {
    if (error != 0) refuse_write(path_.string(), error);
}

void NewFile::add(std::string_view bytes) { require(write_all(file_.get(), bytes)); }

void NewFile::commit() {
    // An output folder flushes all its files at once. Some file systems have no fsync.
    if (!is_in_temporary_folder(path_) && ::fsync(file_.get()) != 0 && errno != EINVAL && errno != EROFS) require(errno);
    if (::renameat(folder_.get(), temporary_.c_str(), folder_.get(), path_.filename().c_str()) != 0) require(errno);
    temporary_.clear();
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw IoError(folder.string(), "the folder cannot be created: " + error.message());
}

void require_writable(const fs::path& file) {
    std::error_code error;
    if (file.filename().empty() || fs::is_directory(file, error)) throw IoError(file.string(), "is a folder, not a file");
    if (const fs::file_status found = fs::status(file, error); fs::exists(found) && !fs::is_regular_file(found))
        throw IoError(file.string(), "is not a regular file");
    remove_parts(file);
    const StopHold hold;
    const NewFile trial(file);  // removed again
}

void require_new_file(const fs::path& file, bool force) {
    require_writable(file);
    std::error_code ignored;
    const fs::file_status found = fs::symlink_status(file, ignored);
    if (!fs::exists(found)) return;
    if (!force) throw IoError(file.string(), "already exists: use --force to replace it, or choose another name");
}

}  // namespace fusee::core
