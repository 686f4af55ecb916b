#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fusee/core/path.h"

namespace fusee::core {

/// Owns a file descriptor.
class Descriptor {
public:
    explicit Descriptor(int value = -1) : value_(value) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }
    [[nodiscard]] int get() const { return value_; }
    [[nodiscard]] int release() { return std::exchange(value_, -1); }
    explicit operator bool() const { return value_ >= 0; }

private:
    int value_;
};

/// An open folder. It stays this folder if its name is moved or replaced; names are relative to it, and no link in them is followed, not
/// even one that appears while fusee runs (openat, O_NOFOLLOW).
class OpenFolder {
public:
    enum class Kind { kNone, kFile, kFolder, kLink, kOther };

    /// A folder that the user names: its links are followed. @throws IoError
    [[nodiscard]] static OpenFolder named(const std::filesystem::path& path);
    /// @param place absolute; a link in it is refused @param shown its name in messages @returns none if it does not exist
    /// @throws IoError naming the part that is a link or no folder
    [[nodiscard]] static std::optional<OpenFolder> find(const std::filesystem::path& place, const std::filesystem::path& shown);
    /// The same; makes what is missing.
    [[nodiscard]] static OpenFolder make(const std::filesystem::path& place, const std::filesystem::path& shown);
    [[nodiscard]] std::optional<OpenFolder> find_inside(const std::filesystem::path& below) const;
    [[nodiscard]] OpenFolder make_inside(const std::filesystem::path& below) const;

    [[nodiscard]] const std::filesystem::path& shown() const { return shown_; }
    [[nodiscard]] int get() const { return folder_.get(); }  ///< for the *at functions
    /// Opens the folder for reading, as flock and fsync need it. @throws IoError
    [[nodiscard]] Descriptor reading() const;
    [[nodiscard]] bool is(const OpenFolder& other) const;
    [[nodiscard]] std::vector<std::string> names() const;  ///< sorted
    [[nodiscard]] Kind kind(const std::string& name) const;
    /// A regular file for reading; never waits for the writer of a pipe. @throws IoError for anything else
    [[nodiscard]] Descriptor open_file(const std::string& name) const;
    /// A new file for appending; no value if the name exists, whatever it is. @throws IoError
    [[nodiscard]] Descriptor create_file(const std::string& name) const;
    /// The bytes of a regular file in pieces. @throws IoError
    void read(const std::string& name, const std::function<void(std::string_view)>& take) const;
    [[nodiscard]] std::string sha256(const std::string& name) const;
    /// @param replaces false: an entry of that name is an error @throws IoError
    void move(const std::string& name, const OpenFolder& to, const std::string& new_name, bool replaces) const;
    void remove(const std::string& name) const;         ///< a file or link. @throws IoError unless it is gone
    bool remove_folder(const std::string& name) const;  ///< @returns false if it is not empty
    void sync() const;                                  ///< flushes the names to the disk. @throws IoError

private:
    OpenFolder(Descriptor folder, std::filesystem::path shown) : folder_(std::move(folder)), shown_(std::move(shown)) {}
    [[nodiscard]] static std::optional<OpenFolder> walk(Descriptor from, std::filesystem::path at, const std::filesystem::path& below,
                                                        bool makes);
    [[nodiscard]] Descriptor copy() const;

    Descriptor folder_;  // O_PATH
    std::filesystem::path shown_;
};

/// Why a write failed, by errno, with the limit that the user can change.
[[nodiscard]] std::string write_failure(int error);

/// Writes all bytes. @returns 0 or errno
[[nodiscard]] int write_all(int file, std::string_view bytes);

/// A file that is written in pieces to a temporary name in the same folder and renamed by `commit`; without commit nothing is left.
/// Inside the staging folder of an OutputFolder no link is followed.
class NewFile {
public:
    explicit NewFile(std::filesystem::path path);  ///< @throws IoError
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    void add(std::string_view bytes);  ///< @throws IoError
    void commit();                     ///< @throws IoError

private:
    void require(int error) const;

    std::filesystem::path path_;
    OpenFolder folder_;
    std::string temporary_;  // empty: renamed
    Descriptor file_;
};

/// The list of the files that fusee made in a folder, kept in that folder.
inline constexpr const char* kManifestName = ".fusee.json";

/// A run that writes into a folder.
struct OutputRun {
    std::string command = {};              ///< "make": a later run of this command removes files that it no longer makes
    std::filesystem::path source = {};     ///< profile, case or table that the files are made from; empty: none
    bool force = false;                    ///< also replace files of another source, and files changed since they were made
    std::vector<std::string> files = {};   ///< names that are always written: checked before the work begins
    std::vector<std::string> sheets = {};  ///< names of files to fill in: once changed they are never replaced, not even with `force`
    bool many_sources = false;             ///< the folder may hold files of other sources
    bool stays = false;                    ///< finished work is committed even after Ctrl-C; else `commit` throws Stopped
    bool among_others = false;             ///< the folder may hold files that fusee did not make, even before the first run
};

/// The output folder of a command: all files are written or none, and the user's files are not touched (docs/outputs.md).
/// Files are written into a hidden folder inside the target and moved to their places, one rename each, by `commit`. The manifest names
/// each file with its SHA-256, the command and the source; only these files are replaced or removed. Two runs on one folder wait for each
/// other. Below the folder that the user names no link is followed, not even one that appears while fusee runs. Without commit nothing is
/// left behind; the next run completes or removes a killed one.
class OutputFolder {
public:
    /// Checks what is known before the work; creates nothing yet.
    /// @throws IoError if the target is a file, holds files but no manifest, belongs to another source, or if a file that is to be written
    /// is not fusee's or was changed
    OutputFolder(std::filesystem::path target, OutputRun run);
    /// The same for out/BELOW. @param out named by the user: it may be a link @param below chosen by the command: no part may be a link
    OutputFolder(const std::filesystem::path& out, const std::filesystem::path& below, OutputRun run);
    ~OutputFolder();
    OutputFolder(OutputFolder&&) noexcept;
    OutputFolder& operator=(OutputFolder&&) = delete;

    /// The folder to write files into before `commit`; created by the first call. May have subfolders. @throws IoError
    [[nodiscard]] const std::filesystem::path& path();
    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    /// The target itself, made if it is missing: for logs, which grow while the command runs.
    [[nodiscard]] OpenFolder open() const;
    /// The same; none if it does not exist.
    [[nodiscard]] std::optional<OpenFolder> find() const;

    /// Moves the files into the target and removes those that an earlier run of the same command and source made, but not this one.
    /// @throws Stopped after Ctrl-C, unless OutputRun::stays: nothing is changed
    /// @throws IoError as the constructor, with nothing changed; or if a file cannot be moved: the next run then completes the commit
    void commit();

private:
    struct Staged;
    std::filesystem::path target_, place_;  // as given; absolute, without links
    OutputRun run_;
    std::string source_;  // relative to place_
    std::unique_ptr<Staged> staged_;
};

/// A new folder PARENT/PREFIXxxxxxx (six random characters), removed with its contents by the destructor.
/// It is locked (flock) while its process lives: the next one with the same parent and prefix removes those of killed processes.
class TemporaryFolder {
public:
    /// @pre `prefix` has no other use @throws IoError naming the parent
    TemporaryFolder(const std::filesystem::path& parent, const std::string& prefix);
    /// Makes a folder in the one for temporary files: $TMPDIR, else /tmp. @throws IoError naming TMPDIR
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
