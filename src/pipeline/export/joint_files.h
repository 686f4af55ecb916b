#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fusee/assembly/assembly.h"
#include "fusee/pipeline/export.h"

namespace fusee::pipeline {

/// The exact solids of the parts as exported, by the names of their files: "k_se", "k_se_mirrored".
using ExactSolids = std::map<std::string, exchange::brep::Brep>;

/// The whole joint as written.
struct JointFiles {
    std::vector<FileRow> files;  ///< assembly.step, assembly.3mf, frame_plate.dxf, sheets of the frame, an STL file of each body to make
    core::Findings findings;
};

/// All bodies in the pose of zero. With STEP among the profile's formats assembly.step, with 3MF assembly.3mf, with DXF the frame's plate;
/// with STL the bodies that the bill of materials has to make, each turned to where it needs least support, as shells that touch:
/// capstan.stl, capstan_mirrored.stl. Warning "brep.validity" and no STEP file if OpenCASCADE makes no solid of a body; none if a part has
/// no exact solid, which is an error already. @throws core::IoError
[[nodiscard]] JointFiles write_joint(const assembly::Assembly& joint, const ExactSolids& parts, const profile::Profile& profile,
                                     const core::Provenance& provenance, const std::filesystem::path& folder);

}  // namespace fusee::pipeline
