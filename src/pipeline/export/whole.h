#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fusee/assembly/assembly.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/export.h"

/// What a design has beside its parts: the torque of both cables together, the joint's files, the plate.
namespace fusee::pipeline {

/// The angles of a single spring's law [rad].
[[nodiscard]] core::Range law_angles(const ResolvedDesign& design);

/// Sets `of_both` of the report: the law, and the difference of both cables' torques by the arms of their first files. With files it adds
/// "readback.torque": of every file and reader that both have, the largest error over the largest torque. @pre design.ways is not empty,
/// and the report has both parts
void judge_both_ways(DesignReport& report, const ResolvedDesign& design);

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

/// Every part on one bed, as written and read back.
struct PlateFiles {
    std::vector<FileRow> files;  ///< plate.3mf and plate.json
    std::vector<readback::ArmError> arm_errors;
    core::Findings findings;
};

/// If the profile asks for 3MF and a plate: writes plate.3mf with every part as one object, arranged within process.build_mm, and
/// plate.json with the place of each; then moves each object of the file back to its part's frame and recomputes its arm.
/// If the bed is too small: warning "plate.bed" and no files. @throws core::IoError
[[nodiscard]] PlateFiles write_plate(const std::vector<ExportedPart>& parts, const profile::Profile& profile,
                                     const core::Provenance& provenance, const std::filesystem::path& folder);

}  // namespace fusee::pipeline
