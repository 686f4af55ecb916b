#include "fusee/core/destination.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <vector>

#include "fusee/core/error.h"

namespace fs = std::filesystem;

namespace fusee::core {

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw IoError(folder.string(), "the folder cannot be created: " + error.message());
}

namespace {
/// Removes what killed processes left in `write_file`.
void remove_parts(const fs::path& file) {
    const std::string prefix = "." + file.filename().string() + ".part-";
    std::error_code ignored;
    std::vector<fs::path> parts;
    for (auto entry = fs::directory_iterator(file.has_parent_path() ? file.parent_path() : ".", ignored);
         !ignored && entry != fs::directory_iterator(); entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(prefix)) continue;
        const int process = std::atoi(name.c_str() + prefix.size());
        if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) parts.push_back(entry->path());
    }
    for (const fs::path& part : parts) fs::remove(part, ignored);
}
}  // namespace

void require_writable(const fs::path& file) {
    std::error_code error;
    if (file.filename().empty() || fs::is_directory(file, error)) throw IoError(file.string(), "is a folder, not a file");
    remove_parts(file);
    const fs::path trial = file.parent_path() / fmt::format(".{}.trial-{}", file.filename().string(), ::getpid());
    const int open = ::open(trial.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (open < 0) throw IoError(file.string(), std::string("cannot be written: ") + std::strerror(errno));
    ::close(open);
    fs::remove(trial, error);
}

void require_new_file(const fs::path& file, bool force) {
    require_writable(file);
    std::error_code ignored;
    const fs::file_status found = fs::symlink_status(file, ignored);
    if (!fs::exists(found)) return;
    if (!force) throw IoError(file.string(), "already exists: use --force to replace it, or choose another name");
    if (!fs::is_regular_file(fs::status(file, ignored))) throw IoError(file.string(), "is not a regular file");
}

}  // namespace fusee::core
