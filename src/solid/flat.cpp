#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

#include "fusee/core/units.h"
#include "fusee/solid/mesh_faults.h"

namespace fusee::solid {

namespace {

using core::cross, core::dot, core::minus;

constexpr double kFlat = 1e-9;  // twice the area over the square of the longest edge
constexpr int kRounds = 50;     // flat triangles in a row are flipped one by one

double square(const Vec3& a) { return dot(a, a); }

double edge_square(const Mesh& mesh, const Triangle& t, std::size_t k) {
    return square(minus(mesh.points_mm[t[(k + 1) % 3]], mesh.points_mm[t[k]]));
}

bool is_flat(const Mesh& mesh, const Triangle& t) {
    const Vec3 u = minus(mesh.points_mm[t[1]], mesh.points_mm[t[0]]), v = minus(mesh.points_mm[t[2]], mesh.points_mm[t[0]]);
    const double longest = std::max({square(u), square(v), square(minus(v, u))});
    return std::sqrt(square(cross(u, v))) <= kFlat * longest;
}

/// The triangle of each directed edge. @pre a manifold, where it is used
class Edges {
public:
    explicit Edges(const Mesh& mesh) {
        owner_.reserve(3 * mesh.triangles.size());
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) set(mesh.triangles[t], t);
    }
    void set(const Triangle& corners, std::uint32_t t) {
        for (std::size_t k = 0; k < 3; ++k) owner_[key(corners[k], corners[(k + 1) % 3])] = t;
    }
    void erase(std::uint32_t a, std::uint32_t b) { owner_.erase(key(a, b)); }
    [[nodiscard]] const std::uint32_t* find(std::uint32_t a, std::uint32_t b) const {
        const auto found = owner_.find(key(a, b));
        return found == owner_.end() ? nullptr : &found->second;
    }
    [[nodiscard]] bool joins(std::uint32_t a, std::uint32_t b) const { return find(a, b) != nullptr || find(b, a) != nullptr; }

private:
    static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return (std::uint64_t{a} << 32U) | b; }
    std::unordered_map<std::uint64_t, std::uint32_t> owner_;
};

/// Flips the longest edge of flat triangle t. @returns false where the new edge exists or the old one has no neighbour
bool flip(Mesh& mesh, Edges& edges, std::uint32_t t) {
    const Triangle corners = mesh.triangles[t];
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (edge_square(mesh, corners, i) > edge_square(mesh, corners, k)) k = i;
    const std::uint32_t a = corners[k], c = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
    const std::uint32_t* const across = edges.find(c, a);
    if (across == nullptr || *across == t) return false;
    const std::uint32_t other = *across;
    const Triangle& far = mesh.triangles[other];
    const auto d_at = std::find_if(far.begin(), far.end(), [&](std::uint32_t p) { return p != a && p != c; });
    if (d_at == far.end() || edges.joins(b, *d_at) || b == *d_at) return false;
    const std::uint32_t d = *d_at;
    edges.erase(a, c), edges.erase(c, a);
    mesh.triangles[t] = {b, a, d}, mesh.triangles[other] = {d, c, b};
    edges.set(mesh.triangles[t], t), edges.set(mesh.triangles[other], other);
    return true;
}

/// Puts two corners of flat triangle t that are at one place together, where the surface stays a manifold: the ends then have just the two
/// neighbours in common that vanish with the edge. @returns whether it did; triangles with a corner twice are left for `erase_collapsed`
bool collapse(Mesh& mesh, std::uint32_t t) {
    const Triangle corners = mesh.triangles[t];
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (edge_square(mesh, corners, i) < edge_square(mesh, corners, k)) k = i;
    const double longest = std::max({edge_square(mesh, corners, 0), edge_square(mesh, corners, 1), edge_square(mesh, corners, 2)});
    const std::uint32_t kept = corners[k], gone = corners[(k + 1) % 3];
    if (kept == gone || edge_square(mesh, corners, k) > kFlat * kFlat * longest) return false;
    std::vector<std::uint32_t> around[2];
    for (const Triangle& other : mesh.triangles)
        for (std::size_t side = 0; side < 2; ++side)
            if (std::find(other.begin(), other.end(), side == 0 ? kept : gone) != other.end())
                around[side].insert(around[side].end(), other.begin(), other.end());
    std::vector<std::uint32_t> common;
    for (auto& list : around) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    std::set_intersection(around[0].begin(), around[0].end(), around[1].begin(), around[1].end(), std::back_inserter(common));
    if (common.size() != 4) return false;  // both ends and the two corners opposite
    for (Triangle& other : mesh.triangles) std::replace(other.begin(), other.end(), gone, kept);
    return true;
}

void erase_collapsed(Mesh& mesh) {
    std::erase_if(mesh.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

}  // namespace

std::vector<std::uint32_t> flat_triangles(const Mesh& mesh) {
    std::vector<std::uint32_t> flat;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (is_flat(mesh, mesh.triangles[t])) flat.push_back(t);
    return flat;
}

Mesh without_flat_triangles(Mesh mesh) {
    std::vector<std::uint32_t> flat = flat_triangles(mesh);
    for (int round = 0; round < kRounds && !flat.empty(); ++round) {
        bool changed = false;
        for (const std::uint32_t t : flat)
            if (collapse(mesh, t)) changed = true;
        erase_collapsed(mesh);
        Edges edges(mesh);
        for (const std::uint32_t t : flat_triangles(mesh))
            if (is_flat(mesh, mesh.triangles[t]) && flip(mesh, edges, t)) changed = true;
        if (!changed) break;
        flat = flat_triangles(mesh);
    }
    return mesh;
}

}  // namespace fusee::solid
