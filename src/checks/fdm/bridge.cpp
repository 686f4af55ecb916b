#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_fdm_bridge(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    if (design.process.kind != ProcessKind::kFdm || hub.kind != solid::HubKind::kOverhung) return {};
    core::Finding f = compare(mm_from_m(2.0 * bore_radius(hub)), {allowed("review")});
    f.what = "span of the ceiling over the blind bore, printed with its boss on the bed";
    f.suggestion = change(design, "hub.bore_mm", down(f.allowed - mm_from_m(hub.bore_clearance)));
    return {f};
}

}  // namespace

Rule fdm_bridge() {
    return {"fdm.bridge",
            "a blind bore whose ceiling sags",
            "FDM, overhung: span of the ceiling over the blind bore",
            "no sag below 5 mm, at most 0.2 mm up to 20 mm (3dorchard): the shaft ends a layer earlier; 10 mm: 3dservicesusa, cifproto, "
            "arti90, "
            "layerx3d",
            {review(kAtMost, "mm", 10.0)},
            measure_fdm_bridge};
}

}  // namespace fusee::checks
