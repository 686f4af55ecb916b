#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/pipeline/check.h"

namespace fusee::app {

/// The process that makes a mesh, and the source of its figures.
struct Machine {
    checks::Process process;
    std::string figures;
    bool own = false;  ///< a profile names this process
};

/// A third-party part, checked for each process.
struct MeshCheck {
    pipeline::Checked checked;
    std::filesystem::path coloured;  ///< the 3MF that shows the findings; empty without --out
};

/// Reads the file and runs the rules of meshes for each machine; the [[limits]] of the file `limits`, unless it is empty, replace the
/// rules' limits. A program without meshes starts the whole one instead (program.h). If `out` is not empty, it writes out/NAME_check.3mf:
/// errors are red, warnings orange, all else grey. @throws core::InvalidInput, core::IoError
[[nodiscard]] MeshCheck check_mesh(const std::filesystem::path& file, const std::vector<Machine>& machines,
                                   const std::filesystem::path& limits, const std::filesystem::path& out, bool force, unsigned jobs);

}  // namespace fusee::app
