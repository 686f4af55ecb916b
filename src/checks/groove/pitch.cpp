#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_groove_pitch(const Design& design, const Allowed& allowed) {
    const Pitch pitch = least_pitch(design.part.cam);
    if (!pitch.turns || design.part.section.empty()) return {};
    const solid::GrooveOptions& groove = design.part.options.groove;
    const double width = groove_width(design.part), wall = process_limits(design.process).wall;
    const double rope = kRopePitch * groove.radius_ratio * design.cable.diameter;
    core::Finding f = compare(mm_from_m(pitch.least), {allowed("required", mm_from_m(std::max(rope, width + wall))),
                                                       allowed("review", mm_from_m(width + groove.rib))});
    f.what = fmt::format("height from one turn to the next; the groove is {:.3f} mm wide, the land between turns {:.2f} mm",
                         mm_from_m(width), mm_from_m(std::max(wall, groove.rib)));
    locate(f, design, pitch.at);
    f.suggestion = change(design, "path.pitch_mm", up(mm_from_m(design.part.cam.options.path.pitch) + f.allowed - f.measured));
    if (design.part.cam.options.path.lead == cam::Lead::kAimedAtGuide)
        f.suggestion = change(design, "guide.z_mm", up(mm_from_m(design.part.cam.options.guide.z) * f.allowed / f.measured))
                           .noted(fmt::format(": the groove then rises by {} mm per turn", up(f.allowed)));
    return {f};
}

}  // namespace

Rule groove_pitch() {
    return {"groove.pitch",
            "turns that overlap",
            "helix: least height from turn to turn",
            "groove width and the process's wall; Unirope/Python: at least 2.065 groove radii",
            {of_process(required(kAtLeast, "mm", "groove width + the process's wall, at least 2.065 floor radii")),
             review(kAtLeast, "mm", "groove width + groove.rib_mm")},
            measure_groove_pitch};
}

}  // namespace fusee::checks
