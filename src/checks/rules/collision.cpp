#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_collision_ball_cutter(const Design& design, const Allowed& allowed) {
    const double cutter = mm_from_m(process_limits(design.process).cutter_radius);
    if (!is_milled(design) || cutter <= 0.0) return {};
    const double ratio = design.part.options.groove.radius_ratio;
    core::Finding f = compare(mm_from_m(ratio * design.cable.diameter), {allowed("required", cutter)});
    f.what = "radius of the groove's floor, which the ball cutter must fit";
    f.suggestion = change("process.cutter_radius_mm", down(f.measured)).or_else(change("cable.diameter_mm", up(f.allowed / ratio)));
    return {f};
}

constexpr double kFleet = rad_from_deg(2.0);

core::Findings measure_collision_printed_land(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    const cam::PathOptions& options = cam.options.path;
    const bool judged = design.process.kind == ProcessKind::kFdm && !cam.closed() && options.lead == cam::Lead::kConstantPitch &&
                        cam.options.guide.kind == cam::GuideKind::kParallel && !design.part.section.empty();
    if (!judged) return {};  // a guide with a place: cable.fleet judges it
    const double turns = cam.working_psi.width() / (2.0 * core::kPi),
                 rope = kRopePitch * design.part.options.groove.radius_ratio * design.cable.diameter;
    const double printed = std::max(options.pitch, groove_width(design.part) + process_limits(design.process).wall);
    const double reach = turns / (2.0 * std::tan(kFleet));
    core::Finding f = compare(mm_from_m(reach * printed), {allowed("review")});
    f.what = fmt::format("least distance of the guide from {:.2f} turns of {:.2f} mm; the cable alone needs {:.0f} mm", turns,
                         mm_from_m(printed), mm_from_m(reach * rope));
    f.suggestion = change(design, "path.lead", quoted("aimed"))
                       .with(key_of(design, "guide.kind"), quoted("point"))
                       .with(key_of(design, "guide.distance_mm"), number(f.allowed))
                       .or_else(change(design, "path.pitch_mm", down(f.allowed / reach)).noted(" with a groove and a land of that width"));
    return {f};
}

core::Findings measure_collision_printed_throat(const Design& design, const Allowed& allowed) {
    const double limit = process_limits(design.process).overhang;
    if (design.process.kind != ProcessKind::kFdm || limit <= 0.0 || design.part.section.size() < 2) return {};
    core::Finding f = compare(deg_from_rad(largest_overhang(design.part)), {allowed("required", deg_from_rad(limit))});
    f.what = "overhang of the groove's upper flank, from the vertical, printed with the axis upright";
    f.where = along_groove(design);
    f.suggestion = change("groove.throat_deg", number(180.0 - 2.0 * f.allowed)).or_else("the part printed with its axis lying");
    return {f};
}

core::Findings measure_collision_rim_undercut(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kMill) return {};
    const solid::GrooveOptions& groove = design.part.options.groove;
    const double depth = mm_from_m(groove.depth_ratio * design.cable.diameter);
    core::Finding f = compare(depth, {allowed("review")});
    f.what = "depth of the groove under its upper flange, out of reach of a tool along the axis";
    f.where = along_groove(design);
    f.suggestion = fmt::format("a 4th axis, a form cutter of {:.3f} mm radius", mm_from_m(groove.radius_ratio * design.cable.diameter));
    if (design.part.cam.closed()) f.suggestion.or_else("two plates split in the plane z 0 mm");
    return {f};
}

}  // namespace

Rules collision_rules() {
    return {
        {"collision.ball_cutter",
         "a groove too narrow for the available ball cutter",
         "milled: radius of the groove's floor",
         "geometry: a cable of 0.8 mm needs a ball below 0.86 mm",
         {required(kAtLeast, "mm", "process.cutter_radius_mm, 0.25 mm by default")},
         measure_collision_ball_cutter},
        {"collision.printed_land",
         "a printed land between turns that needs a distant guide",
         "FDM helix of constant pitch, parallel exit: least distance of its guide, N p/(2 tan 2 deg)",
         "wirerope.net: 2 deg grooved; a guide within 300 mm (practice)",
         {review(kAtMost, "mm", 300.0)},
         measure_collision_printed_land},
        {"collision.printed_throat",
         "a rope's throat whose flank sags in printing",
         "FDM, axis upright: angle of the groove's upper flank from the vertical, 90 deg - throat/2",
         "FDM 45 deg: 3dservicesusa, cifproto, arti90, layerx3d; a rope's throat of 35-60 deg has 60 to 72.5",
         {of_process(required(kAtMost, "deg", "the process's overhang"))},
         measure_collision_printed_throat},
        {"collision.rim_undercut",
         "a rim groove that three axes cannot reach",
         "three axes: depth of the groove under its upper flange",
         "geometry: the groove opens sideways",
         {review(kAtMost, "mm", 0.0)},
         measure_collision_rim_undercut},
    };
}

}  // namespace fusee::checks
