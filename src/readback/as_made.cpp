#include "as_made.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/core/error.h"
#include "fusee/exchange/stl.h"
#include "fusee/readback/readback.h"

namespace fusee::readback {

solid::Mesh as_made(solid::Mesh mesh, const exchange::PartFile& part) {
    if (!part.compensated) return mesh;
    for (auto& point : mesh.points_mm)
        for (std::size_t axis = 0; axis < 3; ++axis) point[axis] *= 1.0 - part.compensated->shrink_percent[axis] / 100.0;
    return mesh;
}

double bore_mm(const std::filesystem::path& stl, const exchange::PartFile& part) {
    constexpr double kFlat_mm = 1e-4;  // single precision at 1 m
    const solid::Mesh mesh = as_made(exchange::read_stl_assimp(stl), part);
    double low = std::numeric_limits<double>::infinity(), radius = low;
    for (const auto& p : mesh.points_mm) low = std::min(low, p[2]);
    for (const auto& p : mesh.points_mm)
        if (p[2] < low + kFlat_mm) radius = std::min(radius, std::hypot(p[0], p[1]));  // the corners of its polygon lie on the hole
    if (!(radius > kFlat_mm)) throw core::IoError(stl.string(), "its lowest face has no hole about the axis");
    return 2.0 * radius - (part.compensated ? part.compensated->bore_offset_mm : 0.0);
}

}  // namespace fusee::readback
