#include "fusee/solid/part.h"

namespace fusee::solid {

core::Outcome<Part> with_wider_bore(const Part& part, double offset) {
    PartOptions options = part.options;
    options.hub.bore_diameter += offset;  // depths of key and flat are measured from the bore's wall, which moves by the same
    if (options.hub.lock == HubLock::kKeyway) options.hub.key_width += offset;
    return build_part(part.cam, options);
}

Mesh grown(const Mesh& mesh, const std::array<double, 3>& shrink) {
    Mesh file = mesh;
    for (Vec3& p : file.points_mm)
        for (std::size_t axis = 0; axis < 3; ++axis) p[axis] /= 1.0 - shrink[axis];
    round_to_file(file);
    return file;
}

}  // namespace fusee::solid
