#include <algorithm>

#include "fusee/core/error.h"
#include "fusee/profile/places.h"

namespace fs = std::filesystem;

namespace fusee::profile {

std::vector<fs::path> find_profiles(const std::vector<fs::path>& paths) {
    std::vector<fs::path> found;
    for (const fs::path& path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            found.push_back(path);  // also one that does not exist: reading it says so
            continue;
        }
        error.clear();
        std::vector<fs::path> inside;
        for (auto entry = fs::directory_iterator(path, error); !error && entry != fs::directory_iterator(); entry.increment(error))
            if (entry->path().extension() == ".toml" && !fs::is_directory(entry->path())) inside.push_back(entry->path());
        if (error) throw core::IoError(path.string(), error.message());
        if (inside.empty()) throw core::IoError(path.string(), "holds no profile (*.toml)");
        std::sort(inside.begin(), inside.end());
        found.insert(found.end(), inside.begin(), inside.end());
    }
    return found;
}

}  // namespace fusee::profile
