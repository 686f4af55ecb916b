#include "durable.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

#include "fusee/core/folder.h"
#include "fusee/core/resource_error.h"

namespace fs = std::filesystem;

namespace fusee::core {

namespace {
/// Starts writing to the disk; many files are then written in parallel.
void begin_sync(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return;
    (void)::sync_file_range(file, 0, 0, SYNC_FILE_RANGE_WRITE);
    ::close(file);
}
}  // namespace

std::string write_failure(int error) {
    return std::string(std::strerror(error)) + (error == EFBIG ? " (ulimit -f states the largest size of a file)" : "");
}

bool is_lack(int error) {
    constexpr std::array kLacks{ENOSPC, EDQUOT, EFBIG, EIO, EMFILE, ENFILE, ENOMEM, EAGAIN};
    return std::find(kLacks.begin(), kLacks.end(), error) != kLacks.end();
}

void refuse_write(const std::string& path, int error) {
    const std::string why = "cannot be written: " + write_failure(error);
    if (is_lack(error)) throw ResourceError(path, why);
    throw IoError(path, why);
}

void sync(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return;
    const int failed = ::fsync(file) != 0 ? errno : 0;
    ::close(file);
    if (failed == EIO || failed == ENOSPC || failed == EDQUOT) refuse_write(path.string(), failed);
}

void sync_tree(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    for (const fs::path& path : files) begin_sync(path);
    for (const fs::path& path : files) sync(path);
}

}  // namespace fusee::core
