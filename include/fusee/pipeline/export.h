#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/provenance.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/readback/readback.h"

namespace fusee::pipeline {

/// The two sides of an antagonistic joint: a part and its mirror image (docs/theory/cams.md).
struct Pair {
    std::shared_ptr<const DesignedPart> agonist;
    std::shared_ptr<const DesignedPart> antagonist;  ///< null: none; its findings are empty: they are those of the agonist
};

/// @param both false: no antagonist
[[nodiscard]] Pair pair_of(DesignedPart agonist, bool both);

/// The antagonist's spring: a coil of the other hand, with the same figures.
[[nodiscard]] spring::BaseSpring mirrored(spring::BaseSpring spring);

/// Which kernel makes the STL.
enum class Via {
    kCgal,      ///< directly from the parametric surface (default: fast)
    kOpenScad,  ///< by OpenSCAD from the exported SCAD file: the independent second kernel
};
[[nodiscard]] const char* to_string(Via via);

/// One part as it went into files.
struct ExportedPart {
    std::string name;                           ///< "k_se", "k_se_mirrored": the beginning of its files' names
    bool mirrored = false;                      ///< the antagonist's
    PartReport report;                          ///< its `part` is the one exported
    solid::Mesh mesh;                           ///< of the STL and 3MF files
    std::optional<exchange::brep::Brep> exact;  ///< of the STEP file
};

/// A part without files: its spring, findings and certificate.
[[nodiscard]] PartReport without_files(const std::shared_ptr<const DesignedPart>& designed, const spring::BaseSpring& spring);

/// Writes both sides of a pair in every format that the profile asks for, with a PART.json for each side, and reads every file back:
/// "k_se", then, if there is one, its mirror image "k_se_mirrored". Broken arms are errors "readback.arm". The reports share the parts with
/// the pair. @param shaft where a part of two cables stands; none: it is alone @throws core::IoError
[[nodiscard]] std::vector<ExportedPart> export_pair(const Pair& pair, const profile::Profile& profile, const core::Provenance& provenance,
                                                    Via via, const std::filesystem::path& folder, const std::optional<OnShaft>& shaft = {});

}  // namespace fusee::pipeline
