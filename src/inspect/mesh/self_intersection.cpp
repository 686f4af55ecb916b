#include <set>

#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_self_intersection(const Foreign& part, const Allowed& allowed) {
    const Body& body = part.body;
    const solid::Crossings& found = body.crossings();
    if (!found.manifold)
        return Marked{core::not_judged("mesh.self_intersection", "the surface is not manifold: self-intersections cannot be determined",
                                       "a manifold surface: see mesh.manifold and mesh.orientation")};
    if (!found.complete)
        return Marked{core::not_judged(
            "mesh.self_intersection",
            fmt::format("more than {} pairs of triangles are near enough to cross; none was checked", solid::kMostNearPairs),
            "a mesh whose triangles do not overlap")};
    std::set<std::uint32_t> triangles;
    for (const auto& [a, b] : found.pairs) triangles.insert({a, b});
    core::Finding f = compare(static_cast<double>(found.pairs.size()), {allowed("required")});
    f.what = "pairs of triangles that intersect";
    if (!triangles.empty()) set_place(f, middle_of(body, *triangles.begin()));
    f.suggestion = fmt::format("a union of the bodies that overlap in {} triangles", triangles.size());
    return Marked{f, {triangles.begin(), triangles.end()}};
}

}  // namespace

Rule mesh_self_intersection() {
    return {{"mesh.self_intersection",
             "a surface that intersects itself",
             "pairs of triangles that intersect; for manifold surfaces only (exact predicates)",
             "a solid has none",
             {required(kAtMost, "pairs", 0.0)}},
            measure_mesh_self_intersection};
}

}  // namespace fusee::inspect
