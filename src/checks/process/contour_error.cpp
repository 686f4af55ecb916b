#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_process_contour_error(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const double tolerance = process_limits(design.process).tolerance;
    if (cam.working.empty() || tolerance <= 0.0) return {};
    const cam::Contact* at = &worst_contact(cam, [](const cam::Contact& c) { return -c.arm.arm; });
    const bool crosses = at->arm.arm <= tolerance;  // an error relative to a torque of 0 says nothing
    if (crosses) at = &worst_contact(cam, [](const cam::Contact& c) { return std::abs(c.arm.arm); });
    const double arm = std::abs(at->arm.arm);
    core::Finding f = compare(100.0 * tolerance / arm, {allowed("review")});
    f.what = fmt::format("torque error {} arm, {:.2f} mm, for a contour error of {:g} mm",
                         crosses ? "as a share of the largest torque, which crosses 0: at the largest" : "at the least", mm_from_m(arm),
                         mm_from_m(tolerance));
    locate(f, design, at->path, -0.5 * design.cable.diameter);
    f.suggestion =
        change("process.tolerance_mm", down(mm_from_m(arm) * f.allowed / 100.0)).noted(": a groove coupon measured and compensated");
    return {f};
}

}  // namespace

Rule process_contour_error() {
    return {"process.contour_error",
            "a process too coarse for the arms",
            "the process's tolerance over the least arm",
            "a contour off by t along its normal changes the arm by t: docs/theory/cams.md; 10 %: as far as rates of bought springs "
            "scatter (Lee "
            "Spring, springs3d)",
            {of_process(review(kAtMost, "%", 10.0))},
            measure_process_contour_error};
}

}  // namespace fusee::checks
