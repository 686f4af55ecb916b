#include "fusee/core/destination.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <system_error>

#include "fusee/core/error.h"

namespace fs = std::filesystem;

namespace fusee::core {

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw IoError(folder.string(), "the folder cannot be made: " + error.message());
}

void require_writable(const fs::path& file) {
    std::error_code error;
    if (fs::is_directory(file, error)) throw IoError(file.string(), "is a folder, not a file");
    const fs::path trial = file.parent_path() / fmt::format(".{}.trial-{}", file.filename().string(), ::getpid());
    if (!std::ofstream(trial)) throw IoError(file.string(), "cannot be written");
    fs::remove(trial, error);
}

}  // namespace fusee::core
