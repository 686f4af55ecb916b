#include "fusee/solid/companions.h"
#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_mill_inner_edge(const Design& design, const Allowed& allowed) {
    const solid::HubLock lock = design.part.options.hub.lock;
    const bool sharp = lock == solid::HubLock::kKeyway || lock == solid::HubLock::kDFlat;
    if (!sharp) return {};
    core::Finding f = compare(0.0, {allowed("review")});
    f.what = fmt::format("radius in the corners of the {}, drawn sharp", lock == solid::HubLock::kKeyway ? "keyway" : "D-flat");
    f.suggestion = solid::set_screw_change(name(design), design.part.options.hub);
    if (design.part.options.hub.kind == solid::HubKind::kThrough)
        f.suggestion.or_else("the bore broached");  // no broach leaves a blind one
    f.suggestion.or_else(fmt::format("corners of {:g} mm accepted", f.allowed));
    return {f};
}

}  // namespace

Rule mill_inner_edge() {
    return {"mill.inner_edge",
            "a sharp inner edge that no mill can cut",
            "milled: radius in the corners of keyway or D-flat",
            "inner edge R >= 0.25 mm feasible: zekes3d, Xometry",
            {review(kAtLeast, "mm", 0.25)},
            measure_mill_inner_edge,
            is_milled};
}

}  // namespace fusee::checks
