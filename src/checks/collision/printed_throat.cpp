#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_collision_printed_throat(const Design& design, const Allowed& allowed) {
    const double limit = process_limits(design.process).overhang;
    if (design.process.kind != ProcessKind::kFdm || limit <= 0.0 || design.part.section.size() < 2) return {};
    core::Finding f = compare(deg_from_rad(largest_overhang(design.part)), {allowed("required", deg_from_rad(limit))});
    f.what = "overhang of the groove's upper flank, from the vertical, printed with the axis upright";
    f.where = along_groove(design);
    f.suggestion = change("groove.throat_deg", number(180.0 - 2.0 * f.allowed)).or_else("the part printed with its axis lying");
    return {f};
}

}  // namespace

Rule collision_printed_throat() {
    return {"collision.printed_throat",
            "a rope's throat whose flank sags in printing",
            "FDM, axis upright: angle of the groove's upper flank from the vertical, 90 deg - throat/2",
            "FDM 45 deg: 3dservicesusa, cifproto, arti90, layerx3d; a rope's throat of 35-60 deg has 60 to 72.5",
            {of_process(required(kAtMost, "deg", "the process's overhang"))},
            measure_collision_printed_throat};
}

}  // namespace fusee::checks
