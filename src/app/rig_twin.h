#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "fusee/core/folder.h"
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"

namespace fusee::app {

/// `--write-mjcf FOLDER` of a gap case: the rig with the effects of a diagnosis as a model for MuJoCo (docs/guides/mujoco.md).
class RigTwin {
public:
    /// Reads the nominal rig of the case in `run.source` and checks the folder; writes nothing.
    /// @param run the command's own; its files are those of the model
    /// @throws core::InvalidInput for a subsystem case, which has no joint; core::IoError
    RigTwin(const std::filesystem::path& folder, core::OutputRun run);

    /// Writes the files. @throws core::InvalidInput if the rig with these effects cannot be built; core::IoError
    void write(const diagnosis::Diagnosis& found);
    [[nodiscard]] std::string line() const;  ///< for the terminal

private:
    gap_case::Case nominal_;
    std::string name_;
    core::OutputFolder output_;
};

/// Gives none without a folder. @param out the folder of the command's other files. @throws core::InvalidInput if it is the same; as
/// RigTwin
[[nodiscard]] std::optional<RigTwin> rig_twin(const std::filesystem::path& folder, const std::filesystem::path& out, core::OutputRun run);
void add_mjcf(CLI::App& command, std::filesystem::path& folder);

}  // namespace fusee::app
