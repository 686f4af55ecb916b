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

}  // namespace

Rule process_build_volume() {
    return {"process.build_volume",
            "a part larger than the machine or the stock",
            "the bounding box's tightest side",
            "process.build_mm; turning about z by 90 deg allowed",
            {of_process(required(kAtMost, "mm", "process.build_mm"))},
            measure_process_build_volume,
            nullptr,
            {},
            true};
}

}  // namespace fusee::checks
