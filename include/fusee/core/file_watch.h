#pragma once
#include <array>
#include <chrono>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "fusee/core/path.h"

namespace fusee::core {

/// Waits for files to be saved: written and closed, replaced by rename, made anew, or named anew, when a link or a folder of their path
/// leads to another place. inotify tells of the first in the files' folders and of their writers; the last is looked up at each wait.
class FileWatch {
public:
    /// @throws IoError if inotify is not available
    FileWatch();
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// Watches these files from now on, existing or not, and no others. @throws IoError naming the folder of a file that is not there or
    /// cannot be watched
    void watch(const std::vector<std::filesystem::path>& files);

    /// Waits until a watched file is saved or removed and nothing more happens for `quiet`; returns false after `most`, or when a signal
    /// arrives before the first change.
    [[nodiscard]] bool wait(std::chrono::milliseconds most, std::chrono::milliseconds quiet);

private:
    /// Where a path leads: its place without links, and the numbers of the folder and the file there; 0: none.
    struct Target {
        std::filesystem::path place;
        std::array<std::uintmax_t, 4> numbers{};
        bool operator==(const Target&) const = default;
    };
    [[nodiscard]] static Target target_of(const std::filesystem::path& file);
    void attach();
    [[nodiscard]] bool take_events();
    [[nodiscard]] bool leads_elsewhere() const;

    int inotify_ = -1;
    std::map<std::filesystem::path, Target> files_;
    std::map<int, std::set<std::string>> watched_;  ///< names by folder, an empty name by file; by watch descriptor
};

}  // namespace fusee::core
