#include <array>

#include "means.h"

namespace fusee::checks {

namespace {

using Size = std::array<double, 3>;  // [mm]

std::size_t tightest(const Size& part, const Size& build) {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (part[i] / build[i] > part[axis] / build[axis]) axis = i;
    return axis;
}

/// Arms (in the plane) or pitch (in height) with which the tightest side fits; empty if no such change suffices.
core::Suggestion smaller_part(const Design& design, std::size_t axis, double size, double build) {
    const cam::Cam& cam = design.part.cam;
    if (axis == 2) {
        const double pitch = mm_from_m(cam.options.path.pitch), turns = cam.groove_psi.width() / (2.0 * core::kPi);
        const double less = cam.closed() ? 0.0 : pitch - (size - build) / turns;
        return less > 0.0 ? change(design, "path.pitch_mm", down(less)) : core::Suggestion();
    }
    // Lips and flanges do not shrink with the contour.
    const double lip = design.part.section.empty() ? 0.0 : lip_offset(design.part);
    const double fixed = 2.0 * mm_from_m(lip + design.part.options.flange_height);
    return build > fixed ? scale_arms(design, (build - fixed) / (size - fixed)) : core::Suggestion();
}

core::Findings measure_process_build_volume(const Design& design, const Allowed& allowed) {
    const Process& process = design.process;
    if (design.part.mesh.points_mm.empty() || process.build_x <= 0.0 || process.build_y <= 0.0 || process.build_z <= 0.0) return {};
    const solid::Box box = solid::bounding_box(design.part.mesh);
    Size size{box.high_mm[0] - box.low_mm[0], box.high_mm[1] - box.low_mm[1], box.high_mm[2] - box.low_mm[2]};
    const Size build{mm_from_m(process.build_x), mm_from_m(process.build_y), mm_from_m(process.build_z)};
    if ((size[0] > size[1]) != (build[0] > build[1])) std::swap(size[0], size[1]);  // turned by 90 deg about z
    const std::size_t axis = tightest(size, build);
    core::Finding f = compare(size[axis], {allowed("required", build[axis])});
    f.what = fmt::format("part of {:.2f} x {:.2f} x {:.2f} mm in a build volume of {:g} x {:g} x {:g} mm", size[0], size[1], size[2],
                         build[0], build[1], build[2]);
    f.where = fmt::format("{} along {}", name(design), "xyz"[axis]);
    f.suggestion = change("process.build_mm", fmt::format("[{}, {}, {}]", up(std::max(size[0], build[0])), up(std::max(size[1], build[1])),
                                                          up(std::max(size[2], build[2]))))
                       .or_else(smaller_part(design, axis, size[axis], build[axis]));
    return {f};
}

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

core::Findings measure_process_detail(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    const double detail = mm_from_m(process_limits(design.process).detail);
    const bool slot = has_slot(features) && (features.mark_width <= 0.0 || features.leg_slot_width < features.mark_width);
    const double narrowest = slot ? features.leg_slot_width : features.mark_width;
    const auto least = allowed.stated("review", detail);
    if (!least || narrowest <= 0.0) return {};
    core::Finding f = compare(mm_from_m(narrowest), {*least});
    f.what = fmt::format("width of the {}", slot ? "spring leg's slot" : "timing mark");
    f.suggestion = change(design, slot ? "features.leg_slot_width_mm" : "features.mark_width_mm", up(f.allowed));
    return {f};
}

core::Findings measure_process_hole(const Design& design, const Allowed& allowed) {
    const Hole least = smallest_hole(design.part);
    core::Finding f = compare(mm_from_m(least.diameter), {allowed("required", mm_from_m(process_limits(design.process).hole))});
    f.what = fmt::format("diameter of the smallest hole: {}", least.what);
    f.suggestion = change(design, least.key, up(f.allowed));
    return {f};
}

struct Wall {
    double thickness;  // [m]
    const char* what;
};

/// Flanges beyond the outermost lips and the land between turns.
std::vector<Wall> walls(const solid::Part& part) {
    std::vector<Wall> all{{part.options.groove.rib, part.cam.closed() ? "flange" : "land between turns"}};
    const std::vector<cam::PathPoint> path = contour(part.cam);
    if (part.section.empty() || path.empty()) return all;
    const auto [low, high] = std::minmax_element(path.begin(), path.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
    const double half = 0.5 * groove_width(part);
    if (part.z_high > part.z_low) {
        all.push_back({part.z_high - high->z - half, "upper flange"});
        all.push_back({low->z - half - part.z_low, "lower flange"});
    }
    if (const Pitch pitch = least_pitch(part.cam); pitch.turns) all.push_back({pitch.least - 2.0 * half, "land between turns"});
    return all;
}

core::Findings measure_process_wall(const Design& design, const Allowed& allowed) {
    const std::vector<Wall> all = walls(design.part);
    const Wall thinnest = *std::min_element(all.begin(), all.end(), [](const Wall& a, const Wall& b) { return a.thickness < b.thickness; });
    core::Finding f = compare(mm_from_m(thinnest.thickness), {allowed("required", mm_from_m(process_limits(design.process).wall))});
    f.what = fmt::format("thinnest wall beside the groove: {}", thinnest.what);
    f.suggestion = change("groove.rib_mm", up(f.allowed));
    if (const Pitch pitch = least_pitch(design.part.cam); pitch.turns && thinnest.thickness < design.part.options.groove.rib)
        f.suggestion = change(design, "path.pitch_mm", up(mm_from_m(pitch.least) + f.allowed - f.measured));
    return {f};
}

}  // namespace

Rules process_rules() {
    return {
        {"process.build_volume",
         "a part larger than the machine or the stock",
         "the bounding box's tightest side",
         "process.build_mm; turning about z by 90 deg allowed",
         {of_process(required(kAtMost, "mm", "process.build_mm"))},
         measure_process_build_volume,
         nullptr,
         {},
         true},
        {"process.contour_error",
         "a process too coarse for the arms",
         "the process's tolerance over the least arm",
         "a contour off by t along its normal changes the arm by t: docs/theory/cams.md; 10 %: as far as rates of bought springs "
         "scatter (Lee "
         "Spring, springs3d)",
         {of_process(review(kAtMost, "%", 10.0))},
         measure_process_contour_error},
        {"process.detail",
         "a slot or mark too narrow for the process",
         "narrowest of timing mark and spring leg's slot",
         "the process's least detail",
         {of_process(review(kAtLeast, "mm", "the process's detail; none for plates"))},
         measure_process_detail},
        {"process.hole",
         "a hole too small to make",
         "diameter of the smallest of bore, anchor hole and screw hole",
         "the process's least hole",
         {of_process(required(kAtLeast, "mm", "the process's hole"))},
         measure_process_hole},
        on_cable({"process.wall",
                  "a wall too thin to make",
                  "thinnest of rib, flanges and land between turns",
                  "the process's thinnest wall",
                  {of_process(required(kAtLeast, "mm", "the process's wall"))},
                  measure_process_wall}),
    };
}

}  // namespace fusee::checks
