#pragma once
#include <filesystem>
#include <string>

#include "fusee/core/open_folder.h"

namespace fusee::core {

/// A new folder PARENT/PREFIXxxxxxx (six random characters), removed with its contents by the destructor.
/// It is locked (flock) while its process lives: the next one with the same parent and prefix removes those of killed processes.
class TemporaryFolder {
public:
    /// @pre `prefix` has no other use @throws IoError naming the parent
    TemporaryFolder(const std::filesystem::path& parent, const std::string& prefix);
    /// In the folder for temporary files: $TMPDIR, else /tmp. @throws IoError naming TMPDIR
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    void make(const std::filesystem::path& parent, const std::string& prefix);

    std::filesystem::path path_;
    int lock_ = -1;  ///< descriptor of the folder
};

/// A folder that is made unless it is there; the destructor removes it again if it is new and empty.
class NewFolder {
public:
    /// @throws IoError as OpenFolder::make
    NewFolder(const std::filesystem::path& place, const std::filesystem::path& shown);
    ~NewFolder();
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

    [[nodiscard]] const OpenFolder& folder() const { return folder_; }

private:
    std::filesystem::path path_;
    bool is_new_ = false;
    OpenFolder folder_;
};

/// Does what the destructors of all living folders of this process do, while other threads may still use them: for an end without
/// destructors (stop.h).
void remove_temporary_folders();

/// Removes the temporary folders of this parent and prefix whose process has ended.
void remove_left_behind(const std::filesystem::path& parent, const std::string& prefix);

/// Is this a name of a temporary folder with that prefix?
[[nodiscard]] bool is_temporary_name(const std::string& name, const std::string& prefix);

/// Is it inside a temporary folder or an output folder's staging folder?
[[nodiscard]] bool is_in_temporary_folder(const std::filesystem::path& path);

/// The prefixes of both.
inline constexpr const char *kTemporaryPrefix = "fusee-temporary-", *kStagingPrefix = ".fusee-staging-";

}  // namespace fusee::core
