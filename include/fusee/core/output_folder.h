#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/open_folder.h"

namespace fusee::core {

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

}  // namespace fusee::core
