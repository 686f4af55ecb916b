#include <fmt/format.h>

#include <cmath>

#include "layout.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

core::Findings measure_joint_frame_stiffness(const Assembly& assembly, const Allowed& allowed) {
    if (assembly.find("frame_plate") == nullptr) return {};
    core::Findings all;
    for (const FrameGive& give : frame_gives(assembly)) {
        core::Finding f = checks::compare(100.0 * give.whole * give.rate, {allowed("review")});
        f.what = fmt::format(
            "give of frame and shafts over that of the springs at the {} cables: {:.3g} um/N beside {:.3g} um/N, {:.3g} um/N by the plate",
            give.cables, 1e6 * give.whole, 1e6 / give.rate, 1e6 * give.plate);
        f.where = "frame_plate";
        const double left = 0.01 * f.allowed / give.rate - (give.whole - give.plate);  // for the plate
        f.suggestion = "brackets of metal";
        if (left > 0.0) f.suggestion = core::change("assembly.wall_mm", checks::up(plate_mm(assembly) * std::cbrt(give.plate / left)));
        all.push_back(std::move(f));
    }
    return all;
}

}  // namespace

Rule joint_frame_stiffness() {
    return {
        {"joint.frame_stiffness",
         "a frame that gives way like a spring",
         "how far plate, rear bracket, tower, posts and shafts follow series and parallel cables as beams, both sides pulled alike, over "
         "the give of the springs behind these cables where they are stiffest",
         "beam theory, without shear; as much as rates of springs scatter: 10 % (EN 15800; springs3d)",
         {review(kAtMost, "%", 10.0)}},
        measure_joint_frame_stiffness};
}

}  // namespace fusee::assembly
