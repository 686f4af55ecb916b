#pragma once
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/solid/part.h"
#include "fusee/toolpath/settings.h"

namespace fusee::toolpath {

/// One G-code file. Its comments say how to set up, and, in words that `read_program` knows, what is cut from which stock with what.
struct Program {
    std::string suffix;  ///< of the file's name: "" or "_blank", "_boss"
    std::string text;
};

/// The spool as two half plates of one sheet, that meet in the groove's plane, each cut from that face on three axes: bore by a helical
/// move, half groove in terraces that leave nothing of the drawn groove filled (the first keeps the floor), then the outline. The contour
/// itself is programmed; G41.1 has the controller keep the cutter's radius to its left, so that a worn cutter is one number.
/// Refusal: "toolpath.bore" (the cutter does not go into the bore).
/// @throws InvalidInput naming the setting, or `path.kind` of a helix
[[nodiscard]] core::Outcome<Program> contour_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// The whole part's outlines and through bore: what `wrap_program` starts from. @pre, refusal and throws as contour_program
[[nodiscard]] core::Outcome<Program> blank_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// A roller cam: its outlines and through bore from above, as of `blank_program`, which are all that it has. Refusal and throws as above.
[[nodiscard]] core::Outcome<Program> rim_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// The boss below a stack as a plate of its own, cut from its lower face. Refusal as contour_program.
/// @pre part.options.hub.boss_height > 0 @throws InvalidInput naming the setting
[[nodiscard]] core::Outcome<Program> boss_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// The groove on a rotary axis (A about X, X along the cam's axis, Z the spindle), planar or helical: A turns the contour's normal upright,
/// so that the spindle stands in the groove's own plane of symmetry and a cutter of the groove's section cuts it true; Y follows the
/// contact, which lies h' beside the axis (docs/theory/toolpaths.md, eq. 2). Inverse time (G93) keeps the feed along the part.
/// @throws InvalidInput naming the setting
[[nodiscard]] Program wrap_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// Every program that the part needs by the method that the settings name for it. Refusals as above.
[[nodiscard]] core::Outcome<std::vector<Program>> part_programs(const solid::Part& part, const Settings& settings,
                                                                const std::string& provenance);

}  // namespace fusee::toolpath
