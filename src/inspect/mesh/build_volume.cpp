#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_build_volume(const Foreign& part, const Allowed& allowed) {
    const solid::Box& box = part.body.box();
    Vec3 size = box.high_mm - box.low_mm;
    const checks::Process& process = part.process;
    const Vec3 build{core::mm_from_m(process.build_x), core::mm_from_m(process.build_y), core::mm_from_m(process.build_z)};
    if ((size[0] > size[1]) != (build[0] > build[1])) std::swap(size[0], size[1]);  // turned by 90 deg about z
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (size[i] / build[i] > size[axis] / build[axis]) axis = i;
    core::Finding f = compare(size[axis], {allowed("required", build[axis])});
    f.what = fmt::format("part of {:.2f} x {:.2f} x {:.2f} mm in a build volume of {:g} x {:g} x {:g} mm", size[0], size[1], size[2],
                         build[0], build[1], build[2]);
    f.where = fmt::format("along {}", "xyz"[axis]);
    f.suggestion = fmt::format("a machine of {} x {} x {} mm, or the part scaled by {}", up(std::max(size[0], build[0])),
                               up(std::max(size[1], build[1])), up(std::max(size[2], build[2])), down(build[axis] / size[axis]));
    return Marked{f};
}

}  // namespace

Rule mesh_build_volume() {
    return {{"mesh.build_volume",
             "a part larger than the machine or the stock",
             "the tightest side of the bounding box",
             "process.build_mm of --profile, else 200 mm; turning about z by 90 deg allowed",
             {required(kAtMost, "mm", "process.build_mm")}},
            measure_mesh_build_volume};
}

}  // namespace fusee::inspect
