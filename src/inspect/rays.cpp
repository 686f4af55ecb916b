#include "fusee/inspect/rays.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>

#include "fusee/inspect/topology.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

// Plain doubles: a ray that passes between two triangles by rounding loses one sample; exact arithmetic slows every sample.
using Kernel = CGAL::Simple_cartesian<double>;
using Facets = std::vector<Kernel::Triangle_3>;

Kernel::Point_3 point(const Vec3& p) { return {p[0], p[1], p[2]}; }

thread_local std::size_t t_visited = 0;

/// CGAL's AABB_triangle_primitive with a counter.
class Primitive {
public:
    using Id = Facets::const_iterator;
    using Point = Kernel::Point_3;
    using Datum = Kernel::Triangle_3;
    using Datum_reference = const Datum&;

    explicit Primitive(Id id) : id_(id) {}
    [[nodiscard]] const Id& id() const { return id_; }
    [[nodiscard]] Datum_reference datum() const {
        ++t_visited;
        return *id_;
    }
    [[nodiscard]] const Point& reference_point() const { return id_->vertex(0); }

private:
    Id id_;
};

/// The point of a triangle with an area nearest to p (C. Ericson, "Real-Time Collision Detection", 2005, 5.1.5). CGAL's method, by the
/// plane and its sides, takes three times as long.
Vec3 nearest_of(const Kernel::Triangle_3& t, const Vec3& p) {
    const auto corner = [&t](int i) { return Vec3{t.vertex(i).x(), t.vertex(i).y(), t.vertex(i).z()}; };
    const Vec3 a = corner(0), b = corner(1), c = corner(2), ab = b - a, ac = c - a;
    const double d1 = dot(ab, p - a), d2 = dot(ac, p - a), d3 = dot(ab, p - b), d4 = dot(ac, p - b), d5 = dot(ab, p - c),
                 d6 = dot(ac, p - c);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + (d1 / (d1 - d3)) * ab;
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
    const double whole = 1.0 / (va + vb + vc);
    return a + (vb * whole) * ab + (vc * whole) * ac;
}

struct Traits : CGAL::AABB_traits<Kernel, Primitive> {
    struct Nearest {
        /// @returns `bound` if nothing of the triangle is nearer than it
        Kernel::Point_3 operator()(const Kernel::Point_3& from, const Primitive& primitive, const Kernel::Point_3& bound) const {
            const Vec3 p{from.x(), from.y(), from.z()}, q = nearest_of(primitive.datum(), p);
            return dot(q - p, q - p) < CGAL::squared_distance(from, bound) ? point(q) : bound;
        }
    };
    [[nodiscard]] Nearest closest_point_object() const { return {}; }
};
using AabbTree = CGAL::AABB_tree<Traits>;

/// A visit along a ray takes as long as four visits for the nearest point, and counts as four.
class CountAsRay {
public:
    CountAsRay() = default;
    ~CountAsRay() { t_visited += 3 * (t_visited - before_); }
    CountAsRay(const CountAsRay&) = delete;
    CountAsRay& operator=(const CountAsRay&) = delete;

private:
    std::size_t before_ = t_visited;
};

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
}
Rays::~Rays() = default;
Rays::Rays(Rays&&) noexcept = default;

bool Rays::empty() const { return tree_->facets.empty(); }

std::optional<Hit> Rays::first(const Vec3& from, const Vec3& direction, std::uint32_t skip) const {
    if (empty()) return std::nullopt;
    const CountAsRay count;
    const auto skipped = [&](Facets::const_iterator facet) { return tree_->number(facet) == skip; };
    const auto found = tree_->tree.first_intersection(ray(from, direction), skipped);
    if (!found) return std::nullopt;
    const auto* at = boost::get<Kernel::Point_3>(&found->first);
    const auto* along = boost::get<Kernel::Segment_3>(&found->first);
    const auto distance = [&](const Kernel::Point_3& p) { return dot(Vec3{p.x(), p.y(), p.z()} - from, direction); };
    return Hit{tree_->number(found->second), at ? distance(*at) : std::min(distance(along->source()), distance(along->target()))};
}

std::vector<std::uint32_t> Rays::all(const Vec3& from, const Vec3& direction) const {
    const CountAsRay count;
    std::vector<Facets::const_iterator> found;
    if (!empty()) tree_->tree.all_intersected_primitives(ray(from, direction), std::back_inserter(found));
    std::vector<std::uint32_t> numbers;
    for (const auto facet : found) numbers.push_back(tree_->number(facet));
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

std::optional<std::pair<Vec3, std::uint32_t>> Rays::nearest(const Vec3& at, double within_mm) const {
    if (empty()) return std::nullopt;
    // A hint bounds the search: only nearer points are found. The caller gives the bound. CGAL's tree of corners, its own source of hints,
    // is not built: it holds one copy of a point for each triangle there, and divides copies endlessly.
    const Facets::const_iterator none = tree_->facets.end();
    const auto [p, facet] = tree_->tree.closest_point_and_primitive(point(at), {point(at + Vec3{within_mm, 0.0, 0.0}), none});
    if (facet == none) return std::nullopt;
    return std::pair{Vec3{p.x(), p.y(), p.z()}, tree_->number(facet)};
}

std::size_t Rays::visited() { return t_visited; }

}  // namespace fusee::inspect
