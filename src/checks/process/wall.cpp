#include "means.h"

namespace fusee::checks {

namespace {

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

Rule process_wall() {
    return on_cable({"process.wall",
                     "a wall too thin to make",
                     "thinnest of rib, flanges and land between turns",
                     "the process's thinnest wall",
                     {of_process(required(kAtLeast, "mm", "the process's wall"))},
                     measure_process_wall});
}

}  // namespace fusee::checks
