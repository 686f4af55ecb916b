#pragma once
#include <filesystem>
#include <vector>

#include "fusee/pipeline/export.h"

namespace fusee::pipeline {

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
