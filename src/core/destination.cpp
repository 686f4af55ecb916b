#include <cerrno>
#include <cstdio>
#include <system_error>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"

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
        int process = 0, serial = 0, end = 0;
        if (!name.starts_with(prefix) || std::sscanf(name.c_str() + prefix.size(), "%d-%d%n", &process, &serial, &end) != 2) continue;
        if (prefix.size() + static_cast<std::size_t>(end) != name.size() || !fs::is_regular_file(entry->symlink_status(ignored))) continue;
        if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) parts.push_back(entry->path());
    }
    for (const fs::path& part : parts) fs::remove(part, ignored);
}
}  // namespace

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
