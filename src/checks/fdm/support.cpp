#include "fusee/checks/support.h"

#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_fdm_support(const Design& design, const Allowed& allowed) {
    const double limit = process_limits(design.process).overhang;
    const solid::Mesh& mesh = design.part.mesh;
    if (design.process.kind != ProcessKind::kFdm || limit <= 0.0 || mesh.triangles.empty()) return {};
    const double upright = unsupported_mm2(mesh, limit, false), flipped = unsupported_mm2(mesh, limit, true);
    core::Finding f = compare(std::min(upright, flipped), {allowed("review")});
    f.what = fmt::format(
        "faces that need support, more than {:g} deg from the vertical, with the {} on the bed as in plate.3mf ({:.0f} mm^2 with the {} "
        "on the bed{})",
        deg_from_rad(limit), upright <= flipped ? "bottom" : "top", std::max(upright, flipped), upright <= flipped ? "top" : "bottom",
        upright <= flipped ? "" : ", as in the part's own files");
    f.suggestion = fmt::format("turn on supports, {} mm^2", up(f.measured));
    return {f};
}

}  // namespace

Rule fdm_support() {
    return {"fdm.support",
            "ceilings that a printer cannot bridge",
            "area of downward faces beyond the overhang + 1 deg, in the better of both orientations",
            "FDM bridge 5-10 mm: 3dservicesusa, cifproto, arti90, layerx3d; a square of 5 mm",
            {review(kAtMost, "mm^2", 25.0)},
            measure_fdm_support,
            nullptr,
            {},
            true};
}

}  // namespace fusee::checks
