#pragma once
#include <cmath>

#include "fusee/solid/mesh.h"

namespace fusee::bench {

/// A torus of n x n quads with a finely waved surface, so that no two triangles are alike.
inline solid::Mesh waved_torus(std::uint32_t n) {
    solid::Mesh mesh;
    const double step = 2.0 * 3.141592653589793 / n;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const double u = i * step, v = j * step, r = 12.0 + 0.2 * std::sin(7 * u) * std::cos(5 * v);
            mesh.points_mm.push_back({(40 + r * std::cos(v)) * std::cos(u), (40 + r * std::cos(v)) * std::sin(u), r * std::sin(v)});
        }
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t a = i * n + j, b = (i + 1) % n * n + j, c = (i + 1) % n * n + (j + 1) % n, d = i * n + (j + 1) % n;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

}  // namespace fusee::bench
