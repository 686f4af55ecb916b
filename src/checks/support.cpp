#include "fusee/checks/support.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"

namespace fusee::checks {

namespace {

constexpr double kSlack = core::rad_from_deg(1.0);  // the angle of a facet differs a little from that of the surface
constexpr double kFirstLayer = 0.05;                // [mm]: a face on the bed needs no support

}  // namespace

double unsupported_mm2(const solid::Mesh& mesh, double overhang, bool flipped) {
    const solid::Box box = solid::bounding_box(mesh);
    const double up = flipped ? -1.0 : 1.0, bed = flipped ? -box.high_mm[2] : box.low_mm[2];
    const double steepest = -std::sin(std::min(overhang + kSlack, 0.5 * core::kPi));
    double area = 0.0;
    for (const solid::Triangle& t : mesh.triangles) {
        const auto &a = mesh.points_mm[t[0]], &b = mesh.points_mm[t[1]], &c = mesh.points_mm[t[2]];
        if (std::max({up * a[2], up * b[2], up * c[2]}) < bed + kFirstLayer) continue;
        const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
        const double twice = std::sqrt(x * x + y * y + z * z);
        if (twice > 0.0 && up * z / twice < steepest) area += 0.5 * twice;
    }
    return area;
}

bool prints_on_its_top(const solid::Mesh& mesh, double overhang) {
    return unsupported_mm2(mesh, overhang, true) < unsupported_mm2(mesh, overhang, false);
}

}  // namespace fusee::checks
