#include <array>

#include "fusee/cam/contact.h"
#include "fusee/solid/companions.h"
#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_cam_arm_range(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::Contact& least = worst_contact(cam, [](const cam::Contact& c) { return -c.arm.arm; });
    const double largest = worst_contact(cam, [](const cam::Contact& c) { return c.arm.arm; }).arm.arm;
    const solid::HubOptions& hub = design.part.options.hub;
    const bool through = hub.kind == solid::HubKind::kThrough;
    const double wall = process_limits(design.process).wall, half_cable = 0.5 * design.cable.diameter;
    // Overhung: no shaft in the groove's plane, but the floor must not cross the axis.
    const double needed = half_cable + (through ? bore_radius(hub) + wall : 0.0);
    core::Finding f = compare(mm_from_m(least.arm.arm), {allowed("required", mm_from_m(needed))});
    f.what = fmt::format("least arm, of {:.2f} to {:.2f} mm (1 : {:.2f}); it must exceed half a cable{}", mm_from_m(least.arm.arm),
                         mm_from_m(largest), largest / least.arm.arm, through ? ", a wall and the bore" : "");
    locate(f, design, least.path, -half_cable);
    f.suggestion = scale_arms(design, f.allowed / f.measured);
    const double bore = 2.0 * (least.arm.arm - half_cable - wall) - hub.bore_clearance;
    if (through && bore > 0.0) f.suggestion.or_else(change(design, "hub.bore_mm", down(mm_from_m(bore))));
    if (through && !is_stacked(design)) f.suggestion.or_else(solid::overhung_change(name(design), hub));
    return {f};
}

core::Findings measure_cam_contour_radius(const Design& design, const Allowed& allowed) {
    const cam::Guide& guide = design.part.cam.options.guide;
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (guide.kind == cam::GuideKind::kParallel || guide.distance <= 0.0 || path.empty()) return {};
    const cam::PathPoint& far = farthest(design.part, path);
    const double idler = guide.kind == cam::GuideKind::kIdler ? guide.radius : 0.0, half_cable = 0.5 * design.cable.diameter;
    const double swept = swept_radius(design.part, far), space = guide.distance - idler - half_cable;
    core::Finding f = compare(mm_from_m(swept), {allowed("review", mm_from_m(space))});
    f.what = "radius swept by the turning part, against the distance to the guide";
    locate(f, design, far, swept - std::hypot(far.h, far.slope));
    f.suggestion = change(design, "guide.distance_mm", up(mm_from_m(swept + idler + half_cable)));
    return {f};
}

constexpr double kFarthest = 10.0;                                    // [m]: the greatest guide.distance_mm
constexpr double kNoCable = 100.0;                                    // [%]: the hole is within the cam
constexpr std::array kHoles = {0.1, 0.12, 0.15, 0.2, 0.3, 0.5, 1.0};  // [m]

/// Distance of a hole at which the parts have a cable: nothing of the turning part reaches it.
double nearest_hole(const solid::Part& part) {
    return swept_radius(part, farthest(part, contour(part.cam))) + 0.5 * part.cam.options.cable_diameter;
}

/// Is there a convex contour with these arms for a cable to a hole at this distance?
bool can_be_cut_for(const cam::Cam& cam, double distance) {
    cam::CamOptions options = cam.options;
    options.guide.kind = cam::GuideKind::kPoint;
    options.guide.distance = distance;
    return std::all_of(cam.working.begin(), cam.working.end(),
                       [&](const cam::Contact& c) { return cam::touch(cam.kind, c.arm, options).path.rho > 0.0; });
}

/// A hole for which the cam can be cut: at the stated distance, else at the first common one.
core::Suggestion point_change(const Design& design, double nearest) {
    const cam::Cam& cam = design.part.cam;
    double hole = cam.options.guide.distance;
    for (const double common : kHoles) {
        if (hole > nearest && can_be_cut_for(cam, hole)) break;
        hole = common;
    }
    return change(design, "guide.kind", quoted("point")).with(key_of(design, "guide.distance_mm"), number(mm_from_m(hole)));
}

/// The least distance at which the error meets the limit, as a change; empty: none within the key's limits.
core::Suggestion distance_change(const Design& design, double least) {
    if (least >= kFarthest) return {};
    return change(design, "guide.distance_mm", up(mm_from_m(least))).noted(" if the cable runs straight for so long");
}

core::Finding not_stated(const Design& design, const Allowed& allowed, double nearest, const EffectiveLimit& error) {
    const double least = cam::least_parallel_distance(design.part.cam, 0.01 * error.value(), {nearest, kFarthest});
    core::Finding f = compare(0.0, {allowed("distance_required", mm_from_m(least))});
    f.what = "the distance of the hole that the cable goes to is not stated: a parallel exit cannot be built without";
    f.suggestion = point_change(design, nearest).or_else(distance_change(design, least));
    return f;
}

core::Findings measure_cam_parallel_exit(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.options.guide.kind != cam::GuideKind::kParallel || cam.working.empty()) return {};
    const double nearest = nearest_hole(design.part), distance = cam.options.guide.distance;
    const EffectiveLimit required = allowed("required"), review = allowed("review");
    if (distance <= 0.0) return {not_stated(design, allowed, nearest, required)};
    const cam::ExitError error = cam::parallel_exit_error(cam, distance);
    core::Finding f = compare(std::isnan(error.relative) ? kNoCable : 100.0 * error.relative, {required, review});
    const cam::PathPoint& at = cam.working[error.row].path;
    f.what = fmt::format("largest error of the arm if the cable goes to a hole {:g} mm away instead of straight off", mm_from_m(distance));
    locate(f, design, at);
    f.suggestion = point_change(design, nearest)
                       .or_else(distance_change(design, cam::least_parallel_distance(cam, 0.01 * f.allowed, {nearest, kFarthest})));
    return {f};
}

}  // namespace

Rules cam_rules() {
    return {
        on_cable({"cam.arm_range",
                  "an arm too short for bore, wall and cable",
                  "least arm",
                  "geometry: r >= bore + wall + d/2",
                  {required(kAtLeast, "mm", "bore + wall + d/2; overhung: d/2")},
                  measure_cam_arm_range,
                  works}),
        {"cam.contour_radius",
         "the turning part striking its guide",
         "largest radius of lips and flanges, swept by turning",
         "geometry: swept circle against the guide",
         {review(kAtMost, "mm", "the distance of point or idler less its radius and d/2")},
         measure_cam_contour_radius},
        on_cable({"cam.parallel_exit",
                  "a cam cut for a cable that leaves parallel, which no hole at a finite distance gives",
                  "parallel exit: largest error of the arm if the cable goes to a hole at guide.distance_mm; without it that distance, 0",
                  "geometry: tangent from the hole; 0.1 % is allowed for the arms of a file (readback.arm), 1 % (practice)",
                  {required(kAtMost, "%", 1.0), review(kAtMost, "%", 0.1),
                   required(kAtLeast, "mm", "the distance at which the error is 1 %", "distance_required")},
                  measure_cam_parallel_exit}),
    };
}

}  // namespace fusee::checks
