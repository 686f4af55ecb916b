#include "means.h"

namespace fusee::checks {

namespace {

/// "the axle's, 6 mm": a torsion spring stands on the axle of its spool, on a sleeve around it, or where the axle is turned down.
std::string what_stands_inside(const Design& design) {
    const double axle = through_axle(design), inside = inner_rod(design);
    const char* what = axle <= 0.0      ? (is_torsion(design) ? "arbor" : "rod")
                       : inside == axle ? "axle"
                       : inside > axle  ? "sleeve on the axle"
                                        : "axle, turned down there";
    return fmt::format("that of the {}, {:g} mm", what, mm_from_m(inside));
}

core::Findings measure_spring_rod(const Design& design, const Allowed& allowed) {
    const double inside = spring::inside_diameter(design.spring, largest_state(design));
    core::Finding f = compare(inside / inner_rod(design), {allowed("required"), allowed("review")});
    f.what = fmt::format("inside diameter of the loaded coils, {:.2f} mm, over {}", mm_from_m(inside), what_stands_inside(design));
    f.suggestion = change(design, "spring.rod_mm", down(mm_from_m(inside / f.allowed)));
    return {f};
}

}  // namespace

Rule spring_rod() {
    return {
        "spring.rod",
        "a coil that seizes on the rod inside it",
        "inside diameter of the coils, wound to the largest state, over that of what stands inside: the guide rod; of K_SE the axle of its "
        "spool, or rod_mm, a sleeve on the axle or the axle turned down",
        "arbor clearance about 10 % (Newcomb)",
        {required(kAtLeast, "", 1.0), review(kAtLeast, "", 1.1)},
        measure_spring_rod,
        nullptr,
        {need::kWire, need::kCoil, need::kRod, need::kWoundCoils}};
}

}  // namespace fusee::checks
