#include "means.h"

namespace fusee::checks {

namespace {

core::Finding web(const Design& design, const EffectiveLimit& required, const EffectiveLimit& review) {
    core::Finding f = compare(mm_from_m(design.part.options.hub.web), {required, review});
    f.what = "web between the blind bore's end and the groove's lower lip";
    f.suggestion = change(design, "hub.web_mm", up(f.allowed));
    return f;
}

core::Findings measure_structure_wall_to_bore(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const ProcessLimits process = process_limits(design.process);
    const EffectiveLimit required = allowed("required", mm_from_m(process.wall)),
                         review = allowed("review", mm_from_m(process.loaded_wall));
    if (hub.kind == solid::HubKind::kOverhung) return {web(design, required, review)};
    const std::vector<cam::PathPoint> path = contour(design.part.cam);
    if (path.empty()) return {};
    const double floor = -0.5 * design.cable.diameter;
    Nearest nearest = distance_inside(path, floor, {0.0, 0.0});
    nearest.distance -= bore_radius(hub);
    bool key = false;
    for (const Vec2& corner : key_corners(hub))
        if (const Nearest at = distance_inside(path, floor, corner); at.distance < nearest.distance) nearest = at, key = true;
    core::Finding f = compare(mm_from_m(nearest.distance), {required, review});
    f.what = fmt::format("wall between the groove's floor and the {}", key ? "keyway's corner" : "bore");
    locate(f, design, nearest.at, floor);
    const double lacking = m_from_mm(f.allowed) - nearest.distance, bore = hub.bore_diameter - 2.0 * lacking;
    if (bore > 0.0) f.suggestion = change(design, "hub.bore_mm", down(mm_from_m(bore)));
    if (nearest.at.h > 0.0) f.suggestion.or_else(scale_arms(design, (nearest.at.h + lacking) / nearest.at.h));
    return {f};
}

}  // namespace

Rule structure_wall_to_bore() {
    return {"structure.wall_to_bore",
            "the groove breaking into the bore, its keyway or the blind bore's end",
            "least wall from groove floor to bore or keyway corner; overhung: the web",
            "the process's walls: thin required, loaded recommended",
            {of_process(required(kAtLeast, "mm", "the process's wall")), of_process(review(kAtLeast, "mm", "the process's loaded wall"))},
            measure_structure_wall_to_bore};
}

}  // namespace fusee::checks
