#pragma once
#include "fusee/core/finding.h"
#include "fusee/toolpath/settings.h"

namespace fusee::toolpath {

/// "aluminium"
[[nodiscard]] const char* to_string(Stuff stuff);
/// Chip load of a carbide cutter [mm per tooth], in proportion to its diameter: aluminium 0.025 and steel 0.013 at 3 mm
/// (machinecalcs.com), plastic 0.036 (fmcarbide.com, 0.03 to 0.06), brass 0.022 (formulafactory.tools, 0.020 to 0.038).
[[nodiscard]] double chip_load_mm(Stuff stuff, double diameter_mm);
/// The feed asked for, or if that is 0 the one of the chip load [m/s].
[[nodiscard]] double feed_of(const Settings& settings, double asked, double diameter_mm, double rpm);
/// Warning "toolpath.chip_load": below 10 um a tooth an edge rubs instead of cutting.
/// @param key of the feed, "machining.feed_mm_per_min" @param where the file
[[nodiscard]] core::Finding judge_chip_load(const Settings& settings, double asked, double diameter_mm, double rpm, const char* key,
                                            const char* where);

}  // namespace fusee::toolpath
