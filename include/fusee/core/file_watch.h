#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace fusee::core {

/// Waits for files to be saved, by inotify: written and closed, replaced by rename, or made anew. The folders are watched, not the files,
/// so that an editor that renames a new file over the old one is seen too.
class FileWatch {
public:
    /// @throws IoError if inotify is not available
    FileWatch();
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// Watches these files from now on, existing or not, and no others. @throws IoError naming a folder that cannot be watched
    void watch(const std::vector<std::filesystem::path>& files);

    /// Waits until a watched file is saved or removed and nothing more happens for `quiet`; returns false after `most`, or when a signal
    /// arrives before the first change.
    [[nodiscard]] bool wait(std::chrono::milliseconds most, std::chrono::milliseconds quiet);

private:
    [[nodiscard]] bool take_events();

    int inotify_ = -1;
    std::map<int, std::filesystem::path> folders_;                  ///< by watch descriptor
    std::map<std::filesystem::path, std::set<std::string>> names_;  ///< watched names by folder
};

}  // namespace fusee::core
