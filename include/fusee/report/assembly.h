#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/assembly/motion.h"
#include "fusee/pipeline/design_report.h"

/// The files of an assembly: assembly.json, bom.csv, assembly.md and the pictures (docs/assembly.md).
namespace fusee::report {

/// assembly.json: every body with its placement at rest, axes, guides, cables and ranges, so that anybody can recompute the joint.
[[nodiscard]] std::string assembly_json(const pipeline::DesignReport& design);
/// bom.csv: item, count, size, note; the parts with the sheets by which they are inspected.
[[nodiscard]] std::string bill_csv(const pipeline::DesignReport& design);
/// assembly.md: sheets for the inspection, order of assembly, cable lengths, preloads, timing marks.
[[nodiscard]] std::string assembly_guide(const pipeline::DesignReport& design);

/// SVG of the joint seen along its axis, at the lowest and at the highest load: hulls without grooves and holes, and free cables.
[[nodiscard]] std::string assembly_plan(const assembly::Assembly& assembly);

/// The joint through one cycle, as an animated PNG that repeats: co-contraction to the greatest turn and back, while the joint swings to
/// both sides. @throws IoError if a picture cannot be written
[[nodiscard]] std::string assembly_motion(const assembly::Assembly& assembly, int longest_px);

inline constexpr int kPicture_px = 1200;  ///< of the longer side
/// Shaded SVG of the joint, with grooves and coils. @throws core::IoError
[[nodiscard]] std::string assembly_view(const assembly::Assembly& assembly, const assembly::Pose& pose, int longest_px);
/// The same at rest, the bodies moved apart and named.
[[nodiscard]] std::string assembly_exploded(const assembly::Assembly& assembly, int longest_px);
/// Both, of kPicture_px at rest.
[[nodiscard]] std::array<std::string, 2> assembly_pictures(const assembly::Assembly& assembly);

/// Writes all of them. @throws core::IoError
std::vector<pipeline::FileRow> write_assembly(const pipeline::DesignReport& design, const std::filesystem::path& folder);

}  // namespace fusee::report
