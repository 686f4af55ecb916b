#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "gcode.h"

namespace fusee::toolpath {

namespace {

using core::cross;
using core::dot;
using core::kTurn;
using core::minus;
using solid::Arc;
using solid::Point2;

constexpr int kFirstPieces = 24;  // a piece is never wider than 15 degrees
constexpr int kDeepest = 12;      // halvings of a piece: 64 microradians, far below any allowed tolerance
constexpr int kProbes = 4;        // normals at which each of the two arcs is compared with the outline

Point2 normal(double psi) { return {std::cos(psi), std::sin(psi)}; }

/// The arc through `from` where its normal has the direction `begin`.
Arc arc_from(const Point2& from, double radius, double begin, double end) {
    const Point2 n = normal(begin);
    return {{from[0] - radius * n[0], from[1] - radius * n[1]}, radius, begin, end};
}

/// Eq. 1: r1 (n(m) - n(a)) + r2 (n(b) - n(m)) = Q - P.
std::array<Arc, 2> biarc(const ConvexOutline& outline, double a, double b) {
    const double m = 0.5 * (a + b);
    const Point2 P = outline(a), Q = outline(b), u = minus(normal(m), normal(a)), v = minus(normal(b), normal(m));
    const Point2 way = minus(Q, P);
    const double area = cross(u, v);
    const Arc first = arc_from(P, cross(way, v) / area, a, m);
    return {first, arc_from(first.at(m), cross(u, way) / area, m, b)};
}

double support_error(const ConvexOutline& outline, const Arc& arc) {
    double worst = arc.radius_mm > 0.0 ? 0.0 : 1e9;
    for (int i = 1; i <= kProbes; ++i) {
        const double psi = arc.begin + (arc.end - arc.begin) * i / kProbes;
        worst = std::max(worst, std::abs(dot(normal(psi), minus(outline(psi), arc.at(psi)))));
    }
    return worst;
}

void fit(const ConvexOutline& outline, double a, double b, double tolerance_mm, int depth, std::vector<Arc>& ring) {
    const auto pair = biarc(outline, a, b);
    if (depth < kDeepest && std::max(support_error(outline, pair[0]), support_error(outline, pair[1])) > tolerance_mm) {
        fit(outline, a, 0.5 * (a + b), tolerance_mm, depth + 1, ring);
        fit(outline, 0.5 * (a + b), b, tolerance_mm, depth + 1, ring);
        return;
    }
    ring.insert(ring.end(), pair.begin(), pair.end());
}

}  // namespace

std::vector<Arc> fit_arcs(const ConvexOutline& outline, double start, double tolerance_mm) {
    std::vector<Arc> ring;
    for (int i = 0; i < kFirstPieces; ++i)
        fit(outline, start + kTurn * i / kFirstPieces, start + kTurn * (i + 1) / kFirstPieces, tolerance_mm, 0, ring);
    return ring;
}

std::vector<Arc> parallel(std::vector<Arc> ring, double offset_mm) {
    for (Arc& arc : ring) arc.radius_mm += offset_mm;
    return ring;
}

std::vector<Arc> turned_over(const std::vector<Arc>& ring) {
    std::vector<Arc> result;
    for (auto arc = ring.rbegin(); arc != ring.rend(); ++arc)
        result.push_back({{arc->centre_mm[0], -arc->centre_mm[1]}, arc->radius_mm, -arc->end, -arc->begin});
    return result;
}

}  // namespace fusee::toolpath
