#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_fdm_elephant_foot(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kFdm) return {};
    core::Finding f = compare(mm_from_m(design.part.options.hub.bore_clearance), {allowed("review")});
    f.what = "clearance of the bore, which the squeezed first layer reduces";
    f.where = name(design) + " at the bore's mouth";
    f.suggestion = change(design, "hub.clearance_mm", number(f.allowed)).or_else("a chamfer there");
    return {f};
}

}  // namespace

Rule fdm_elephant_foot() {
    return {"fdm.elephant_foot",
            "a bore narrowed by the squeezed first layer",
            "FDM: clearance of the bore, which opens on the bed",
            "0.1 mm a side (practice)",
            {review(kAtLeast, "mm", 0.2)},
            measure_fdm_elephant_foot};
}

}  // namespace fusee::checks
