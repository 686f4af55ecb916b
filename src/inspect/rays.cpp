#include "fusee/inspect/rays.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>

#include "fusee/inspect/topology.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

// Plain doubles: a ray that slips between two triangles by rounding costs one sample, exact arithmetic costs every sample.
using Kernel = CGAL::Simple_cartesian<double>;
using Facets = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Facets::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 point(const Vec3& p) { return {p[0], p[1], p[2]}; }
Kernel::Ray_3 ray(const Vec3& from, const Vec3& direction) {
    return {point(from), Kernel::Vector_3(direction[0], direction[1], direction[2])};
}

}  // namespace

struct Rays::Tree {
    Facets facets;
    std::vector<std::uint32_t> numbers;  ///< of the facets in the mesh
    AabbTree tree;

    [[nodiscard]] std::uint32_t number(Facets::const_iterator facet) const {
        return numbers[static_cast<std::size_t>(facet - facets.begin())];
    }
};

Rays::Rays(const solid::Mesh& mesh) : tree_(std::make_unique<Tree>()) {
    const std::vector<std::uint32_t> flat = flat_triangles(mesh);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (std::binary_search(flat.begin(), flat.end(), t)) continue;
        const solid::Triangle& c = mesh.triangles[t];
        tree_->facets.emplace_back(point(mesh.points_mm[c[0]]), point(mesh.points_mm[c[1]]), point(mesh.points_mm[c[2]]));
        tree_->numbers.push_back(t);
    }
    const Facets& facets = tree_->facets;
    tree_->tree.insert(facets.begin(), facets.end());
    tree_->tree.build();
    if (!facets.empty()) tree_->tree.accelerate_distance_queries();
}
Rays::~Rays() = default;
Rays::Rays(Rays&&) noexcept = default;

bool Rays::empty() const { return tree_->facets.empty(); }

std::optional<Hit> Rays::first(const Vec3& from, const Vec3& direction, std::uint32_t skip) const {
    if (empty()) return std::nullopt;
    const auto skipped = [&](Facets::const_iterator facet) { return tree_->number(facet) == skip; };
    const auto found = tree_->tree.first_intersection(ray(from, direction), skipped);
    if (!found) return std::nullopt;
    const auto* at = boost::get<Kernel::Point_3>(&found->first);
    const auto* along = boost::get<Kernel::Segment_3>(&found->first);
    const auto distance = [&](const Kernel::Point_3& p) { return dot(Vec3{p.x(), p.y(), p.z()} - from, direction); };
    return Hit{tree_->number(found->second), at ? distance(*at) : std::min(distance(along->source()), distance(along->target()))};
}

std::vector<std::uint32_t> Rays::all(const Vec3& from, const Vec3& direction) const {
    std::vector<Facets::const_iterator> found;
    if (!empty()) tree_->tree.all_intersected_primitives(ray(from, direction), std::back_inserter(found));
    std::vector<std::uint32_t> numbers;
    for (const auto facet : found) numbers.push_back(tree_->number(facet));
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

std::pair<Vec3, std::uint32_t> Rays::nearest(const Vec3& at) const {
    const auto [p, facet] = tree_->tree.closest_point_and_primitive(point(at));
    return {{p.x(), p.y(), p.z()}, tree_->number(facet)};
}

}  // namespace fusee::inspect
