#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/solid/mesh.h"
#include "taut_cable.h"

/// The groove of a helical cam as its mesh has it, and a cable on its floor. Shares nothing with module cam.
namespace fusee::helix {

using Eigen::Vector3d;

struct FloorPoint {
    double radius = 0.0, z = 0.0;  ///< [mm]
};

/// Bottoms of all grooves that a half plane through the axis cuts: the vertices of its outline that are nearer to the axis than both
/// neighbours. @param azimuth in the body's frame [rad]
inline std::vector<FloorPoint> bottoms(const solid::Mesh& mesh, double azimuth) {
    const Vector3d along(std::cos(azimuth), std::sin(azimuth), 0.0), across(-along.y(), along.x(), 0.0);
    std::vector<std::array<FloorPoint, 2>> cuts;
    for (const auto& t : mesh.triangles) {
        std::vector<FloorPoint> ends;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3d p(mesh.points_mm[t[i]].data()), q(mesh.points_mm[t[(i + 1) % 3]].data());
            const double u = across.dot(p), v = across.dot(q);
            if ((u < 0.0) == (v < 0.0)) continue;
            const Vector3d at = u < 0.0 ? p + (q - p) * (u / (u - v)) : q + (p - q) * (v / (v - u));  // one order for both triangles
            ends.push_back({along.dot(at), at.z()});
        }
        if (ends.size() == 2 && ends[0].radius > 0.0 && ends[1].radius > 0.0) cuts.push_back({ends[0], ends[1]});
    }
    std::vector<FloorPoint> found;
    for (const auto& cut : cuts) {
        const FloorPoint& low = cut[0].radius < cut[1].radius ? cut[0] : cut[1];
        const FloorPoint& high = cut[0].radius < cut[1].radius ? cut[1] : cut[0];
        for (const auto& other : cuts) {  // the neighbour on the other side of the bottom rises too
            const bool first = std::abs(other[0].radius - low.radius) < 1e-9 && std::abs(other[0].z - low.z) < 1e-9;
            const bool second = std::abs(other[1].radius - low.radius) < 1e-9 && std::abs(other[1].z - low.z) < 1e-9;
            if (first == second) continue;
            const FloorPoint& far = first ? other[1] : other[0];
            if (far.radius > low.radius && high.z < low.z && far.z > low.z) found.push_back(low);
        }
    }
    return found;
}

/// The floor as a chain of points, found from one of its places on in both directions, a step of azimuth each [rad].
inline std::vector<Vector3d> floor(const solid::Mesh& mesh, const Vector3d& place, double step) {
    const double begin = std::atan2(place.y(), place.x());
    const auto followed = [&](double sense) {
        std::vector<Vector3d> chain;
        FloorPoint at{std::hypot(place.x(), place.y()), place.z()};
        double near = 1.0;  // the place is a cable's centreline, which is half a cable outside
        for (int i = sense > 0.0 ? 0 : 1;; ++i) {
            const double azimuth = begin + sense * step * i;
            const FloorPoint* next = nullptr;
            const auto found = bottoms(mesh, azimuth);
            const auto apart = [&](const FloorPoint& p) { return std::hypot(p.radius - at.radius, p.z - at.z); };
            for (const FloorPoint& p : found)
                if (apart(p) < near && (next == nullptr || apart(p) < apart(*next))) next = &p;
            if (next == nullptr) return chain;
            at = *next, near = 0.3;
            chain.emplace_back(at.radius * std::cos(azimuth), at.radius * std::sin(azimuth), at.z);
        }
    };
    std::vector<Vector3d> back = followed(-1.0);
    const std::vector<Vector3d> forth = followed(1.0);
    std::reverse(back.begin(), back.end());
    back.insert(back.end(), forth.begin(), forth.end());
    return back;
}

/// Length of a cable on the floor [mm]: from the chain's first point, or its last one where the sense is below 0, along the groove and to
/// the guide. Its centreline runs `half` outside the floor.
/// @param chain the floor @param guide in the same frame @param sense of the tension's moment @param z, near only floor points at this
/// height, by less than `near`, may be the last one: the others belong to another turn [mm]
inline double cable_length(const std::vector<Vector3d>& chain, const Vector3d& guide, double half, double sense, double z, double near) {
    const std::size_t n = chain.size();
    std::size_t touched = 0;
    double most = -INFINITY;
    taut::Vec normal{};
    for (std::size_t i = 1; i + 1 < n; ++i) {
        if (std::abs(chain[i].z() - z) > near) continue;
        const double x = guide.x() - chain[i].x(), y = guide.y() - chain[i].y();
        const double turn = std::atan2(y, x) - sense * std::acos(half / std::hypot(x, y));
        const taut::Vec at{std::cos(turn), std::sin(turn)};
        if (const double moment = at[0] * chain[i].x() + at[1] * chain[i].y(); moment > most) most = moment, touched = i, normal = at;
    }
    std::vector<Vector3d> line(chain);
    taut::Vec last{};
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const Vector3d along = chain[i + 1] - chain[i - 1];
        const double size = std::hypot(along.x(), along.y());
        const taut::Vec outward{along.y() / size, -along.x() / size};
        line[i] += half * Vector3d(outward[0], outward[1], 0.0);
        if (i == touched) last = outward;
    }
    double wound = 0.0;
    for (std::size_t i = 2; i + 1 < n; ++i)
        if (sense > 0.0 ? i <= touched : i > touched) wound += (line[i] - line[i - 1]).norm();
    const double x = guide.x() - chain[touched].x(), y = guide.y() - chain[touched].y(), up = guide.z() - chain[touched].z();
    return wound + half * sense * std::atan2(taut::cross(last, normal), taut::dot(last, normal)) +
           std::sqrt(x * x + y * y - half * half + up * up);
}

}  // namespace fusee::helix
