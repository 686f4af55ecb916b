#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/resource_error.h"

namespace fusee::core {

namespace {

constexpr int kEnter = O_PATH | O_DIRECTORY | O_CLOEXEC;

[[noreturn]] void refuse(const fs::path& shown, const std::string& why) { throw IoError(shown.string(), why); }
[[noreturn]] void refuse(const fs::path& shown, int error) { refuse(shown, std::strerror(error)); }

OpenFolder::Kind kind_of(mode_t mode) {
    if (S_ISREG(mode)) return OpenFolder::Kind::kFile;
    if (S_ISDIR(mode)) return OpenFolder::Kind::kFolder;
    return S_ISLNK(mode) ? OpenFolder::Kind::kLink : OpenFolder::Kind::kOther;
}

OpenFolder::Kind kind_at(int folder, const char* name) {
    struct stat found {};
    return ::fstatat(folder, name, &found, AT_SYMLINK_NOFOLLOW) == 0 ? kind_of(found.st_mode) : OpenFolder::Kind::kNone;
}

/// One part of a path could not be entered.
[[noreturn]] void refuse_part(int folder, const char* name, const fs::path& shown, int error) {
    const OpenFolder::Kind kind = kind_at(folder, name);
    if (kind == OpenFolder::Kind::kLink)
        refuse(shown, "is a link, and fusee follows only links that you name yourself: remove it, or choose another folder");
    if (kind == OpenFolder::Kind::kFile || kind == OpenFolder::Kind::kOther)
        refuse(shown, "is a file, not a folder: move it, or choose another folder");
    refuse(shown, "the folder cannot be opened: " + std::string(std::strerror(error)));
}

}  // namespace

Descriptor::~Descriptor() {
    if (value_ >= 0) ::close(value_);
}

std::optional<OpenFolder> OpenFolder::walk(Descriptor from, fs::path at, const fs::path& below, bool makes) {
    for (const fs::path& part : below) {
        if (part.empty() || part == ".") continue;
        at /= part;
        const auto enter = [&] { return Descriptor(::openat(from.get(), part.c_str(), kEnter | O_NOFOLLOW)); };
        Descriptor next = enter();
        if (!next && errno == ENOENT) {
            if (!makes) return std::nullopt;
            if (::mkdirat(from.get(), part.c_str(), 0777) != 0 && errno != EEXIST)
                refuse(at, std::string("the folder cannot be created: ") + std::strerror(errno));
            next = enter();
        }
        if (!next) refuse_part(from.get(), part.c_str(), at, errno);
        from = std::move(next);
    }
    return OpenFolder(std::move(from), std::move(at));
}

OpenFolder OpenFolder::named(const fs::path& path) {
    Descriptor folder(::open(path.empty() ? "." : path.c_str(), kEnter));
    if (!folder) refuse(path, errno);
    return {std::move(folder), path};
}

std::optional<OpenFolder> OpenFolder::find(const fs::path& place, const fs::path& shown) {
    auto found = walk(Descriptor(::open("/", kEnter)), "/", place.relative_path(), false);
    if (found) found->shown_ = shown;
    return found;
}

OpenFolder OpenFolder::make(const fs::path& place, const fs::path& shown) {
    OpenFolder made = *walk(Descriptor(::open("/", kEnter)), "/", place.relative_path(), true);
    made.shown_ = shown;
    return made;
}

Descriptor OpenFolder::copy() const {
    Descriptor same(::fcntl(get(), F_DUPFD_CLOEXEC, 0));
    if (!same) refuse(shown_, errno);
    return same;
}

std::optional<OpenFolder> OpenFolder::find_inside(const fs::path& below) const { return walk(copy(), shown_, below, false); }
OpenFolder OpenFolder::make_inside(const fs::path& below) const { return *walk(copy(), shown_, below, true); }

Descriptor OpenFolder::reading() const {
    Descriptor same(::openat(get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!same) refuse(shown_, "cannot be read: " + std::string(std::strerror(errno)));
    return same;
}

bool OpenFolder::is(const OpenFolder& other) const {
    struct stat here {
    }, there{};
    return ::fstat(get(), &here) == 0 && ::fstat(other.get(), &there) == 0 && here.st_dev == there.st_dev && here.st_ino == there.st_ino;
}

std::vector<std::string> OpenFolder::names() const {
    const std::unique_ptr<DIR, int (*)(DIR*)> list(::fdopendir(reading().release()), ::closedir);
    if (!list) refuse(shown_, "cannot be read: " + std::string(std::strerror(errno)));
    std::vector<std::string> all;
    errno = 0;
    while (const dirent* entry = ::readdir(list.get()))
        if (std::string name = entry->d_name; name != "." && name != "..") all.push_back(std::move(name));
    if (errno != 0) refuse(shown_, "cannot be read: " + std::string(std::strerror(errno)));
    std::sort(all.begin(), all.end());
    return all;
}

OpenFolder::Kind OpenFolder::kind(const std::string& name) const { return kind_at(get(), name.c_str()); }

Descriptor OpenFolder::open_file(const std::string& name) const {
    const fs::path file = shown_ / name;
    Descriptor open(::openat(get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (!open && errno == ELOOP) refuse(file, "is a link, and fusee follows only links that you name yourself");
    if (!open) refuse(file, errno);
    struct stat found {};
    if (::fstat(open.get(), &found) != 0 || !S_ISREG(found.st_mode)) refuse(file, "is a folder, a pipe or a device, not a file");
    return open;
}

Descriptor OpenFolder::create_file(const std::string& name) const {
    Descriptor file(::openat(get(), name.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!file && errno != EEXIST) refuse_write((shown_ / name).string(), errno);
    return file;
}

void OpenFolder::read(const std::string& name, const std::function<void(std::string_view)>& take) const {
    const Descriptor file = open_file(name);
    std::array<char, 1 << 16> piece;
    for (ssize_t count = 0; (count = ::read(file.get(), piece.data(), piece.size())) != 0;) {
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) refuse(shown_ / name, "cannot be read to its end: " + std::string(std::strerror(errno)));
        take({piece.data(), static_cast<std::size_t>(count)});
    }
}

std::string OpenFolder::sha256(const std::string& name) const {
    Sha256 hash;
    read(name, [&hash](std::string_view piece) { hash.add(piece); });
    return hash.hex();
}

void OpenFolder::move(const std::string& name, const OpenFolder& to, const std::string& new_name, bool replaces) const {
    int failed = ::renameat2(get(), name.c_str(), to.get(), new_name.c_str(), replaces ? 0 : RENAME_NOREPLACE);
    if (failed != 0 && !replaces && (errno == EINVAL || errno == ENOSYS)) {  // a file system without this flag
        if (to.kind(new_name) != Kind::kNone)
            errno = EEXIST;
        else
            failed = ::renameat(get(), name.c_str(), to.get(), new_name.c_str());
    }
    if (failed == 0) return;
    if (errno == EEXIST && !replaces) refuse(to.shown_ / new_name, "appeared while fusee ran, and is not replaced: move it");
    refuse_write((to.shown_ / new_name).string(), errno);
}

void OpenFolder::remove(const std::string& name) const {
    if (::unlinkat(get(), name.c_str(), 0) != 0 && errno != ENOENT)
        refuse(shown_ / name, "cannot be removed: " + std::string(std::strerror(errno)));
}

bool OpenFolder::remove_folder(const std::string& name) const { return ::unlinkat(get(), name.c_str(), AT_REMOVEDIR) == 0; }

void OpenFolder::sync() const {
    const Descriptor open = reading();
    if (::fsync(open.get()) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT)) refuse_write(shown_.string(), errno);
}

}  // namespace fusee::core
