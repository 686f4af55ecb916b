#include "means.h"

namespace fusee::checks {

namespace {

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

}  // namespace

Rule collision_printed_land() {
    return {"collision.printed_land",
            "a printed land between turns that needs a distant guide",
            "FDM helix of constant pitch, parallel exit: least distance of its guide, N p/(2 tan 2 deg)",
            "wirerope.net: 2 deg grooved; a guide within 300 mm (practice)",
            {review(kAtMost, "mm", 300.0)},
            measure_collision_printed_land};
}

}  // namespace fusee::checks
