#include "scene/packed.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/text.h"

namespace fusee::report {

namespace {

constexpr double kBoxSteps = 65535.0;

void add_little_endian(std::string& to, std::unsigned_integral auto value) {
    for (std::size_t byte = 0; byte < sizeof value; ++byte) to.push_back(static_cast<char>((value >> (8 * byte)) & 0xff));
}

}  // namespace

double PackedMesh::error_mm() const { return 0.5 * *std::max_element(step_mm.begin(), step_mm.end()); }

PackedMesh packed(const solid::Mesh& mesh) {
    const solid::Box box = solid::bounding_box(mesh);
    PackedMesh out;
    out.low_mm = box.low_mm;
    for (std::size_t k = 0; k < 3; ++k) out.step_mm[k] = (box.high_mm[k] - box.low_mm[k]) / kBoxSteps;
    std::string points, triangles;
    for (const solid::Vec3& p : mesh.points_mm)
        for (std::size_t k = 0; k < 3; ++k) {
            const double count = out.step_mm[k] > 0.0 ? (p[k] - out.low_mm[k]) / out.step_mm[k] : 0.0;
            add_little_endian(points, static_cast<std::uint16_t>(std::clamp(std::round(count), 0.0, kBoxSteps)));
        }
    out.wide = mesh.points_mm.size() > 65536;
    for (const solid::Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : t) {
            if (out.wide) add_little_endian(triangles, corner);
            if (!out.wide) add_little_endian(triangles, static_cast<std::uint16_t>(corner));
        }
    out.points = core::base64(points), out.triangles = core::base64(triangles);
    return out;
}

}  // namespace fusee::report
