#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"

namespace fusee::checks {

namespace {

constexpr double kSlack = core::rad_from_deg(1.0);  // facets lean a little more or less than the surface
constexpr double kFirstLayer = 0.05;                // [mm]: what lies on the bed needs no support

/// Area of faces that look down by more than `limit` and do not lie on the bed [mm^2]. @param up +1: bottom on the bed, -1: top on the bed
double unsupported(const solid::Mesh& mesh, const solid::Box& box, double limit, int up) {
    const double bed = up > 0 ? box.low_mm[2] : -box.high_mm[2], steepest = -std::sin(std::min(limit + kSlack, 0.5 * core::kPi));
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

core::Findings run(const Design& design, const Allowed& allowed) {
    const double limit = process_limits(design.process).overhang;
    const solid::Mesh& mesh = design.part.mesh;
    if (design.process.kind != ProcessKind::kFdm || limit <= 0.0 || mesh.triangles.empty()) return {};
    const solid::Box box = solid::bounding_box(mesh);
    const double upright = unsupported(mesh, box, limit, 1), flipped = unsupported(mesh, box, limit, -1);
    core::Finding f = judge(std::min(upright, flipped), {allowed("review")});
    f.what = fmt::format("faces that look down by more than {:g} deg, printed with the {} on the bed (the other way up: {:.0f} mm^2)",
                         core::deg_from_rad(limit), upright <= flipped ? "bottom" : "top", std::max(upright, flipped));
    f.suggestion = fmt::format("support material under {} mm^2", up(f.measured));
    return {f};
}

}  // namespace

Rule fdm_support() {
    return {"fdm.support",
            "ceilings that a printer cannot bridge",
            "area looking down beyond the overhang + 1 deg, the better way up",
            "FDM bridge 5-10 mm: 3dservicesusa, cifproto, arti90, layerx3d; a square of 5 mm",
            {review(kAtMost, "mm^2", 25.0)},
            run,
            true};
}

}  // namespace fusee::checks
