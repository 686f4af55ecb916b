#include "fusee/cam/mirror.h"

#include <algorithm>
#include <utility>

#include "fusee/core/units.h"
#include "fusee/solid/part.h"

namespace fusee::solid {

namespace {

/// The columns keep their places and are numbered from the start of the mirrored groove.
std::vector<double> mirrored(const std::vector<double>& columns_psi, double groove_begin) {
    constexpr double kSame = 1e-6;  // [rad]: the column at the start of the groove may be rounded to before it
    std::vector<double> columns;
    columns.reserve(columns_psi.size());
    for (const double psi : columns_psi) columns.push_back(core::within_turn(-psi, groove_begin - kSame));
    std::sort(columns.begin(), columns.end());
    return columns;
}

}  // namespace

Mesh mirrored(const Mesh& mesh) {
    Mesh other = mesh;
    for (Vec3& p : other.points_mm) p[1] = -p[1];
    for (Triangle& t : other.triangles) std::swap(t[1], t[2]);
    return other;
}

PartOptions mirrored(const PartOptions& options) {
    PartOptions other = options;
    other.features.leg_slot_angle = -options.features.leg_slot_angle;
    return other;
}

Part mirrored(const Part& part) {
    Part other = part;
    other.cam = cam::mirrored(part.cam);
    other.options = mirrored(part.options);
    other.mesh = mirrored(part.mesh);
    other.skin = mirrored(part.skin);
    other.columns_psi = mirrored(part.columns_psi, other.cam.groove_psi.low);
    return other;
}

}  // namespace fusee::solid
