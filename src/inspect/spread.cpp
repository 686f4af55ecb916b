#include "spread.h"

#include <cmath>
#include <numeric>

#include "vector.h"

namespace fusee::inspect {

namespace {

/// k-th point of the R2 sequence (M. Roberts, 2018: the plastic number's powers), folded into the triangle.
Vec3 place_in(const solid::Mesh& mesh, const solid::Triangle& t, std::size_t k) {
    constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
    double whole = 0.0;
    double u = std::modf(0.5 + kFirst * static_cast<double>(k), &whole), v = std::modf(0.5 + kSecond * static_cast<double>(k), &whole);
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    const Vec3 &a = mesh.points_mm[t[0]], &b = mesh.points_mm[t[1]], &c = mesh.points_mm[t[2]];
    return (1.0 - u - v) * a + u * b + v * c;
}

}  // namespace

std::vector<Sample> spread(const Body& body, std::size_t count) {
    const std::vector<double>& areas = body.areas_mm2();
    const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
    const auto facets = static_cast<double>(areas.size());
    std::vector<Sample> samples;
    samples.reserve(count + 1);
    double sum = 0.0;  // of the triangles' shares of the count, so far
    for (std::uint32_t t = 0; t < areas.size(); ++t) {
        if (!(areas[t] > 0.0)) continue;
        const double expected = 0.5 * static_cast<double>(count) * (areas[t] / area + 1.0 / facets);
        sum += expected;
        while (static_cast<double>(samples.size()) + 0.5 < sum) {
            Sample sample;
            sample.triangle = t;
            sample.at_mm = place_in(body.mesh(), body.mesh().triangles[t], samples.size());
            sample.share_mm2 = areas[t] / expected;
            samples.push_back(sample);
        }
    }
    return samples;
}

}  // namespace fusee::inspect
