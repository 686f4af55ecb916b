#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace fusee::core {

/// The list of what fusee made in a folder, kept in that folder.
inline constexpr const char* kManifestName = ".fusee.json";

/// A run that writes into a folder.
struct OutputRun {
    std::string command = {};              ///< "make": a later run of this command removes the files that it no longer makes
    std::filesystem::path source = {};     ///< profile, case or table that the files are made from; empty: none
    bool force = false;                    ///< also replace the files of another source, and files that were changed since they were made
    std::vector<std::string> files = {};   ///< names that will be written in any case: checked before the work begins
    std::vector<std::string> sheets = {};  ///< names of files to fill in: once changed they are never replaced, not even with `force`
    bool many_sources = false;             ///< files of other sources may stand beside those of this run
    bool among_others = false;             ///< files that fusee did not make may stand beside them from the beginning
};

/// A folder that a command writes its files into: all of them or none, and nothing of the user's is touched (docs/outputs.md).
/// Files are written into a hidden folder inside the target and moved to their places, one rename each, by `commit`. The manifest names
/// each file with its SHA-256, the command and the source; only these files are replaced or removed. Two runs on one folder wait for each
/// other. Left uncommitted it leaves nothing behind; a killed run is completed or cleared away by the next one.
class OutputFolder {
public:
    /// Judges what is known before the work; creates nothing yet.
    /// @throws IoError if the target is a file, holds files but no manifest, belongs to another source, or if a file that is to be written
    /// is not fusee's or was changed
    OutputFolder(std::filesystem::path target, OutputRun run);
    ~OutputFolder();
    OutputFolder(OutputFolder&&) noexcept;
    OutputFolder& operator=(OutputFolder&&) = delete;

    /// Where files are written before `commit`; made by the first call. May have folders inside. @throws IoError
    [[nodiscard]] const std::filesystem::path& path();
    [[nodiscard]] const std::filesystem::path& target() const { return target_; }

    /// Moves the files into the target and removes those that an earlier run of the same command and source made and this one did not.
    /// @throws IoError as the constructor, with nothing changed; or if a file cannot be moved: then the next run completes it
    void commit();

private:
    struct Staged;
    std::filesystem::path target_, place_;  // as given; absolute, without links
    OutputRun run_;
    std::string source_;  // relative to place_
    std::unique_ptr<Staged> staged_;
};

}  // namespace fusee::core
