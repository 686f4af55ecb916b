#include <array>

#include "measure.h"

namespace fusee::inspect {

namespace {

constexpr double kSlack = core::rad_from_deg(1.0);  // the angle of a facet differs a little from that of the surface
constexpr double kFirstLayer_mm = 0.05;             // a face on the bed needs no support

struct Side {
    const char* name;
    Vec3 up;
};
constexpr std::array kSides = {Side{"-z", {0, 0, 1}},  Side{"+z", {0, 0, -1}}, Side{"-x", {1, 0, 0}},
                               Side{"+x", {-1, 0, 0}}, Side{"-y", {0, 1, 0}},  Side{"+y", {0, -1, 0}}};

struct Hanging {
    double area_mm2 = 0.0;
    std::vector<std::uint32_t> triangles;
};

/// Downward faces beyond the process's overhang that do not lie on the bed, with `up` upward.
Hanging hanging(const Body& body, const Vec3& up, double overhang) {
    const auto& points = body.mesh().points_mm;
    double bed = INFINITY;
    for (const Vec3& p : points) bed = std::min(bed, dot(p, up));
    const double steepest = -std::sin(std::min(overhang + kSlack, 0.5 * core::kPi));
    Hanging found;
    for (std::uint32_t t = 0; t < body.mesh().triangles.size(); ++t) {
        if (!(dot(body.normals()[t], up) < steepest)) continue;
        double highest = -INFINITY;
        for (const std::uint32_t p : body.mesh().triangles[t]) highest = std::max(highest, dot(points[p], up));
        if (highest < bed + kFirstLayer_mm) continue;
        found.area_mm2 += body.areas_mm2()[t];
        found.triangles.push_back(t);
    }
    return found;
}

std::optional<Marked> measure_mesh_overhang(const Foreign& part, const Allowed& allowed) {
    const double overhang = checks::process_limits(part.process).overhang;
    if (!(overhang > 0.0)) return std::nullopt;
    const Hanging found = hanging(part.body, kSides.front().up, overhang);
    core::Finding f = compare(found.area_mm2, {allowed("review")});
    f.what = fmt::format("downward faces at more than {:g} deg from the vertical, printed in the orientation of the file",
                         core::deg_from_rad(overhang));
    if (!found.triangles.empty()) set_place(f, middle_of(part.body, found.triangles.front()));
    if (f.severity == core::Severity::kPass) return Marked{f};
    const Side* best = &kSides.front();
    double least = found.area_mm2;
    for (const Side& side : kSides)
        if (const double area = hanging(part.body, side.up, overhang).area_mm2; area < least) least = area, best = &side;
    f.suggestion = least < found.area_mm2 ? fmt::format("printed on its {} side, with {} mm^2 of such faces", best->name, up(least))
                                          : fmt::format("turn on supports, {} mm^2; no other side is better", up(least));
    return Marked{f, found.triangles};
}

}  // namespace

Rule mesh_overhang() {
    return {{"mesh.overhang",
             "ceilings that a printer cannot bridge",
             "FDM: area of downward faces beyond the overhang + 1 deg that are not on the bed, z upward",
             "FDM bridge 5-10 mm: 3dservicesusa, cifproto, arti90, layerx3d; a square of 5 mm",
             {review(kAtMost, "mm^2", 25.0)}},
            measure_mesh_overhang};
}

}  // namespace fusee::inspect
