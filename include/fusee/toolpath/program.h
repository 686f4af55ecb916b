#pragma once
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/solid/part.h"
#include "fusee/toolpath/settings.h"

namespace fusee::toolpath {

/// One G-code file. Its comments state the setup and, in words that `cut_floors` reads, the cuts, the stock and the cutter.
struct Program {
    std::string suffix;  ///< of the file's name: "" or "_blank", "_boss"
    std::string text;
    core::Findings findings = {};  ///< warnings: "toolpath.dowels", "toolpath.index", "toolpath.chip_load"
};

/// The spool as two half plates of one sheet. They meet in the groove's plane, and each is cut from that face on three axes: bore by a
/// helical move, half groove in terraces that leave no material inside the nominal groove (the first one has the floor's radius), then the
/// outline. The contour itself is programmed; with G41.1 the controller keeps the cutter's radius to its left, so that a worn cutter
/// changes one number only.
/// Refusal: "toolpath.bore" (the cutter is too wide for the bore).
/// @throws InvalidInput naming the setting, or `path.kind` of a helix
[[nodiscard]] core::Outcome<Program> contour_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// The whole part's outlines and through bore, and the hole for its index pin: the blank of `wrap_program`. @pre, refusal and throws as
/// contour_program
[[nodiscard]] core::Outcome<Program> blank_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// A roller cam: its outlines and through bore from above, as in `blank_program`; it has no other features. Refusal and throws as above.
[[nodiscard]] core::Outcome<Program> rim_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// The boss below a stack as a separate plate, cut from its lower face. Refusal as contour_program.
/// @pre part.options.hub.boss_height > 0 @throws InvalidInput naming the setting
[[nodiscard]] core::Outcome<Program> boss_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// The groove on a rotary axis (A about X, X along the cam's axis, Z the spindle), planar or helical: A turns the contour's normal to the
/// spindle, so that the spindle lies in the groove's plane of symmetry and a cutter of the groove's section cuts it exactly. Y follows the
/// contact, which lies h' beside the axis (docs/theory/toolpaths.md, eq. 2). Inverse time (G93) keeps the feed along the part constant.
/// @throws InvalidInput naming the setting
[[nodiscard]] Program wrap_program(const solid::Part& part, const Settings& settings, const std::string& provenance);

/// All programs of the part by the method in the settings. Refusals as above.
[[nodiscard]] core::Outcome<std::vector<Program>> part_programs(const solid::Part& part, const Settings& settings,
                                                                const std::string& provenance);

}  // namespace fusee::toolpath
