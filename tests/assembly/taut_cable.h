#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

/// Plane geometry of a taut cable on a convex polygon, written for the tests alone: it shares nothing with module cam.
namespace fusee::taut {

using Vec = std::array<double, 2>;

inline double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double cross(const Vec& a, const Vec& b) { return a[0] * b[1] - a[1] * b[0]; }
inline Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// Counter-clockwise convex hull (Andrew's monotone chain).
inline std::vector<Vec> hull(std::vector<Vec> points) {
    std::sort(points.begin(), points.end());
    std::vector<Vec> chain;
    for (int half = 0; half < 2; ++half) {
        const std::size_t begin = chain.size();
        for (const Vec& p : points) {
            while (chain.size() >= begin + 2 && cross(minus(chain.back(), chain[chain.size() - 2]), minus(p, chain.back())) <= 0.0)
                chain.pop_back();
            chain.push_back(p);
        }
        chain.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return chain;
}

/// Length of a cable whose centreline runs `half` outside a polygon: from the point `from` to the polygon and on around it to the edge that
/// begins at its vertex `anchor`. @param sense of the tension's moment about the polygon's inside
inline double length(const std::vector<Vec>& polygon, std::size_t anchor, double half, const Vec& from, double sense) {
    const std::size_t n = polygon.size();
    std::size_t touched = 0;
    double most = -INFINITY;
    Vec normal{};
    for (std::size_t i = 0; i < n; ++i) {
        const Vec w = minus(from, polygon[i]);
        const double turn = std::atan2(w[1], w[0]) - sense * std::acos(half / std::hypot(w[0], w[1]));
        const Vec at{std::cos(turn), std::sin(turn)};
        if (const double moment = dot(at, polygon[i]); moment > most) most = moment, touched = i, normal = at;
    }
    const Vec w = minus(from, polygon[touched]);
    double total = std::sqrt(dot(w, w) - half * half);
    // The cable arrives with its normal and follows the outline against the sense of its moment.
    const auto next = [&](std::size_t i) { return sense > 0.0 ? (i + n - 1) % n : (i + 1) % n; };
    for (std::size_t i = touched;; i = next(i)) {
        const Vec &a = polygon[i], &b = polygon[next(i)];
        const Vec edge = minus(b, a);
        const double size = std::hypot(edge[0], edge[1]);
        const Vec outward{sense > 0.0 ? -edge[1] / size : edge[1] / size, sense > 0.0 ? edge[0] / size : -edge[0] / size};
        total += half * std::atan2(std::abs(cross(normal, outward)), dot(normal, outward));
        if (i == anchor) return total;
        total += size;
        normal = outward;
    }
}

}  // namespace fusee::taut
