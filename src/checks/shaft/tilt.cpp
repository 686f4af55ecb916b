#include "means.h"

namespace fusee::checks {

namespace {

bool is_overhung(const Design& design) {
    return works(design) && design.part.options.hub.kind == solid::HubKind::kOverhung && bore_length(design.part) > 0.0;
}

core::Findings measure_shaft_tilt(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const double length = bore_length(design.part);
    core::Finding f = compare(deg_from_rad(std::atan(hub.bore_clearance / length)), {allowed("review")});
    f.what = fmt::format("angle by which the cam can tilt on its shaft: {:g} mm of clearance over {:.3g} mm of bore",
                         mm_from_m(hub.bore_clearance), mm_from_m(length));
    const double longer = hub.bore_clearance / std::tan(rad_from_deg(f.allowed)) - length;
    f.suggestion = change(design, "hub.boss_height_mm", up(mm_from_m(hub.boss_height + longer)));
    return {f};
}

}  // namespace

Rule shaft_tilt() {
    return on_cable({"shaft.tilt",
                     "an overhung cam that tilts on its shaft, so that its cable leaves the groove's plane at an angle",
                     "overhung: clearance of the bore over its length",
                     "geometry; limit: that of cable.fleet, wirerope.net",
                     {review(kAtMost, "deg", 2.0)},
                     measure_shaft_tilt,
                     is_overhung});
}

}  // namespace fusee::checks
