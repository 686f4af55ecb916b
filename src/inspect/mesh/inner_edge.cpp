#include "measure.h"
#include "seam.h"

namespace fusee::inspect {

namespace {

constexpr double kSharp = core::rad_from_deg(35.0);  // a smaller angle is the facet of a rounding
constexpr double kUpright = 0.95;                    // cosine of an edge with z

struct InnerEdges {
    double least_radius_mm = NAN;
    Vec3 at{};
    std::vector<std::uint32_t> triangles;
    void take(const std::vector<std::uint32_t>& more, double radius, const Vec3& where, double limit) {
        if (radius < limit) triangles.insert(triangles.end(), more.begin(), more.end());
        if (!(radius >= least_radius_mm)) least_radius_mm = radius, at = where;
    }
};

/// Inner edges along the tool: rounded ones with their radius, sharp ones with 0. Holes are drilled and do not count.
InnerEdges inner_edges(const Body& body, double limit) {
    InnerEdges found;
    std::vector<bool> rounded(body.mesh().triangles.size(), false);
    for (const Hollow& h : body.hollows()) {
        for (const std::uint32_t t : h.triangles) rounded[t] = true;
        if (!h.is_hole() && std::abs(h.axis[2]) > kUpright) found.take(h.triangles, 0.5 * h.diameter_mm, h.middle_mm, limit);
    }
    for_each_seam(body, [&](const Seam& s) {
        if (!s.concave || s.turn < kSharp || std::abs(s.along[2]) < kUpright || (rounded[s.a] && rounded[s.b])) return;
        found.take({s.a, s.b}, 0.0, middle_of(body, s.a), limit);
    });
    std::sort(found.triangles.begin(), found.triangles.end());
    found.triangles.erase(std::unique(found.triangles.begin(), found.triangles.end()), found.triangles.end());
    return found;
}

std::optional<Marked> measure_mesh_inner_edge(const Foreign& part, const Allowed& allowed) {
    const auto limit = allowed.stated("review", core::mm_from_m(checks::process_limits(part.process).cutter_radius));
    if (!limit) return std::nullopt;
    const InnerEdges found = inner_edges(part.body, limit->value());
    if (std::isnan(found.least_radius_mm)) return std::nullopt;
    core::Finding f = compare(found.least_radius_mm, {*limit});
    f.what = "least radius of an inner edge along z, where the cutter leaves its own radius";
    set_place(f, found.at);
    f.suggestion = fmt::format("rounded by {} mm, or relieved by a hole of {} mm", up(f.allowed), up(2.0 * f.allowed));
    return Marked{f, found.triangles};
}

}  // namespace

Rule mesh_inner_edge() {
    return {{"mesh.inner_edge",
             "an inner edge sharper than the cutter",
             "milled, cut: least radius of the inner edges along z; 0 for one that turns by 35 deg or more in one edge",
             "the process's cutter radius",
             {of_process(review(kAtLeast, "mm", "the process's cutter radius; none printed"))}},
            measure_mesh_inner_edge};
}

}  // namespace fusee::inspect
