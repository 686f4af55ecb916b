#pragma once
#include <string>
#include <vector>

#include "fusee/assembly/motion.h"
#include "fusee/pipeline/design_report.h"

/// The pictures of the pages as files of their own, for papers and READMEs (docs/guides/pictures.md).
namespace fusee::report {

enum class Theme { kLight, kDark };

struct PictureView {
    std::string name;     ///< "dead-band"
    std::string meaning;  ///< in words
};
/// The views of a design.
[[nodiscard]] const std::vector<PictureView>& design_views();
/// The view of a diagnosis (gap_map_picture in diagnosis.h).
inline constexpr const char* kGapMapView = "gap-map";
/// The view of a joint in motion (motion_picture).
inline constexpr const char* kMotionView = "motion";

struct PictureOptions {
    Theme theme = Theme::kLight;  ///< of charts; shaded views are on white
    assembly::Pose pose = {};     ///< of the view "assembly"
    int longest_px = 1200;        ///< of the shaded picture inside
};
/// One view of a design as an SVG with its style inside.
/// @throws InvalidInput naming --view: not one of design_views(), or the design does not have it (a flat part's groove has no height; no
/// assembly)
[[nodiscard]] std::string design_picture(const pipeline::DesignReport& design, const std::string& view, const PictureOptions& options = {});

/// The joint through one cycle of co-contraction, an animated PNG (assembly_motion in assembly.h). @throws InvalidInput naming --view: the
/// design has no assembly
[[nodiscard]] std::string motion_picture(const pipeline::DesignReport& design, int longest_px);

}  // namespace fusee::report
