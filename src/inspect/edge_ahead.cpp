#include "edge_ahead.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

constexpr double kParallel = core::rad_from_deg(1.0);
constexpr double kEdge = 0.1, kAngle = 0.02;  // of the first width: nearly nothing is left; the angle is measured
constexpr double kBlunt = 0.1;                // of the width there: the way that is left to the end. An edge of 157 deg has as much
constexpr double kWider = 1.02;               // facets of a curved face differ from it
constexpr int kSteps = 24;                    // each goes half of the way that is left

}  // namespace

std::optional<SharpEdge> edge_ahead(const Body& body, Vec3 middle, Vec3 one, Vec3 other, double width_mm) {
    std::optional<SharpEdge> edge;
    Vec3 ahead{};
    double way = 0.0, width = width_mm;
    for (int i = 0; i < kSteps; ++i) {
        const Vec3 sum = one + other;
        const double half_sine = std::min(1.0, 0.5 * length(sum)), half_width = 0.5 * width;
        if (i == 0 && half_sine < 0.5 * kParallel) return std::nullopt;
        if (i == 0 || dot(sum, ahead) > 0.0) ahead = unit(sum);                    // single facets may be inclined the other way
        const double to_edge = half_width / std::max(half_sine, 0.5 * kParallel);  // if the faces were flat
        if (width <= kEdge * width_mm) edge = SharpEdge{2.0 * std::asin(half_sine), width_mm, way + to_edge};
        if (width <= kAngle * width_mm) return edge;
        const auto end = body.rays().first(middle, ahead, kNone);
        if (!end || end->distance_mm < kBlunt * width) return edge;
        const double step = 0.5 * std::min(end->distance_mm, to_edge);
        middle = middle + step * ahead, way += step;
        const Vec3 across = unit(one - other);
        const auto there = body.rays().first(middle, across, kNone), back = body.rays().first(middle, -1.0 * across, kNone);
        if (!there || !back || there->distance_mm + back->distance_mm > kWider * width) return edge;
        middle = middle + 0.5 * (there->distance_mm - back->distance_mm) * across;
        one = body.normals()[there->triangle], other = body.normals()[back->triangle];
        width = there->distance_mm + back->distance_mm;
    }
    return edge;
}

}  // namespace fusee::inspect
