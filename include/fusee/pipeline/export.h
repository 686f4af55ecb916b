#pragma once
#include <filesystem>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/provenance.h"
#include "fusee/pipeline/design.h"
#include "fusee/readback/readback.h"
#include "fusee/report/report.h"

namespace fusee::pipeline {

/// Which kernel makes the STL.
enum class Via {
    kCgal,      ///< directly from the parametric surface (default: fast)
    kOpenScad,  ///< by OpenSCAD from the exported SCAD file: the independent second kernel
};
[[nodiscard]] const char* to_string(Via via);

/// A file as written: name, SHA-256 and size of its bytes. @throws core::IoError
[[nodiscard]] report::FileRow file_row(const std::filesystem::path& path, std::size_t triangles = 0, double chordal_error_mm = 0.0);

/// Writes one part in every format that the profile asks for, with PART.json beside it, and reads every file back.
/// Broken arms come back as required findings "readback.arm".
/// @throws core::IoError
[[nodiscard]] report::PartReport export_part(const DesignedPart& designed, const profile::Profile& profile,
                                             const core::Provenance& provenance, Via via, const std::filesystem::path& folder);

}  // namespace fusee::pipeline
