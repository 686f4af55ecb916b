#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/pipeline/check.h"

namespace fusee::app {

/// How a mesh is to be made, and whose figures these are.
struct Machine {
    checks::Process process;
    std::string figures;
    bool own = false;  ///< a profile names this process
};

/// A third-party part, checked for each process.
struct MeshCheck {
    pipeline::Checked checked;
    std::filesystem::path coloured;  ///< the 3MF that shows where; empty if none was asked for
};

/// Reads the file, runs the mesh's rules for each machine, with `limits` in the place of their own, and, where `out` is not empty, writes
/// out/NAME_check.3mf: red where an error is, orange where a warning, grey elsewhere. @throws core::InvalidInput, core::IoError
[[nodiscard]] MeshCheck check_mesh(const std::filesystem::path& file, const std::vector<Machine>& machines,
                                   const std::vector<checks::Override>& limits, const std::filesystem::path& out, bool force,
                                   unsigned jobs);

}  // namespace fusee::app
