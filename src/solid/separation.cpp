#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "fusee/core/progress.h"
#include "fusee/core/units.h"
#include "fusee/solid/mesh_faults.h"
#include "near_pairs.h"

namespace fusee::solid {

namespace {

using core::cross, core::dot, core::minus;

constexpr double kRounding = 1e-14;  // 45 times the rounding of one operation: a bound of the few in each product below
constexpr double kSlender = 1e-12;   // twice an area over the square of the longest side: less counts as none

Vec3 plus(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
/// A bound of the length from above, without a root.
double size(const Vec3& a) { return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]); }
Vec3 unit(const Vec3& a) {
    const double of_a = length(a);
    return of_a > 0.0 ? Vec3{a[0] / of_a, a[1] / of_a, a[2] / of_a} : a;
}

/// Sign of (a x b).c: 0 where rounding leaves it open.
int side(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double volume = dot(cross(a, b), c), bound = kRounding * size(a) * size(b) * size(c);
    return volume > bound ? 1 : volume < -bound ? -1 : 0;
}

/// Bounds of m.p over points, for this m: the rounding of m itself does not matter.
struct Span {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(const Vec3& m, const Vec3& p) {
        const double at = dot(m, p), bound = kRounding * size(m) * size(p);
        low = std::min(low, at - bound);
        high = std::max(high, at + bound);
    }
};

/// Two triangles as seen from one point.
using Corners = std::array<Vec3, 3>;
Corners seen(const Mesh& mesh, const Triangle& t, const Vec3& from) {
    return {minus(mesh.points_mm[t[0]], from), minus(mesh.points_mm[t[1]], from), minus(mesh.points_mm[t[2]], from)};
}

bool between(const Vec3& m, const Corners& f, const Corners& g) {
    Span of_f, of_g;
    for (const Vec3& p : f) of_f.add(m, p);
    for (const Vec3& p : g) of_g.add(m, p);
    return of_f.high < of_g.low || of_g.high < of_f.low;
}

Vec3 side_from(const Corners& t, std::size_t i) { return minus(t[(i + 1) % 3], t[i]); }

/// A plane along one side of each: a triangle may stand on the plane of the other one, and rise over its corner.
bool apart_along_sides(const Corners& f, const Corners& g) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (between(cross(side_from(f, i), side_from(g, k)), f, g)) return true;
    return false;
}

/// Two triangles without a common corner: all of one is on one side of the other's plane, or a plane upright on one of its sides.
bool apart_from(const Corners& f, const Corners& g) {
    const Vec3 normal = cross(side_from(f, 0), side_from(f, 1));
    if (between(normal, f, g)) return true;
    for (std::size_t i = 0; i < 3; ++i)
        if (between(cross(normal, side_from(f, i)), f, g)) return true;
    return false;
}

/// The common corner is the origin, with the corners a, b and c, d counter-clockwise about it: is one sector on one side of a plane through
/// it and the other one on the other side?
bool sectors_apart(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int over_c = side(a, b, c), over_a = side(c, d, a);
    if (over_c != 0 && over_c == side(a, b, d)) return true;
    if (over_a != 0 && over_a == side(c, d, b)) return true;
    const Vec3 up = plus(unit(cross(a, b)), unit(cross(c, d)));
    for (const auto& [last, next] : {std::pair{b, c}, std::pair{a, d}}) {  // through the gap between both
        const Vec3 m = cross(up, plus(unit(last), unit(next)));
        Span of_f, of_g;
        for (const Vec3& p : {a, b}) of_f.add(m, p);
        for (const Vec3& p : {c, d}) of_g.add(m, p);
        if ((of_f.high < 0.0 && of_g.low > 0.0) || (of_g.high < 0.0 && of_f.low > 0.0)) return true;
    }
    return false;
}

/// Two faces on the side from p to q: they meet elsewhere only if one is folded onto the other.
bool unfolded(const Vec3& side_pq, const Vec3& a, const Vec3& b) {
    if (side(side_pq, a, b) != 0) return true;
    const Vec3 left = cross(side_pq, a), right = cross(b, side_pq);
    return dot(left, right) > kRounding * dot(side_pq, side_pq) * size(a) * size(b);
}

/// Place of a triangle's corner in another one; 3: none.
std::size_t place_in(const Triangle& t, std::uint32_t v) { return static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin()); }

bool without_area(const Mesh& mesh, const Triangle& t) {
    const Corners at = seen(mesh, t, mesh.points_mm[t[0]]);
    const double longest = std::max({dot(at[1], at[1]), dot(at[2], at[2]), dot(minus(at[2], at[1]), minus(at[2], at[1]))});
    return !(length(cross(at[1], at[2])) > kSlender * longest);
}

/// Ends the search before it has seen every pair.
struct TooMany final : std::exception {};

}  // namespace

bool surely_apart(const Mesh& mesh, const Triangle& f, const Triangle& g) {
    std::size_t common = 0, shared = 0, own = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool in_g = place_in(g, f[i]) != 3;
        common += in_g ? 1 : 0;
        (in_g ? shared : own) = i;
    }
    const std::size_t at = common == 1 ? shared : common == 2 ? (own + 1) % 3 : 0;  // the common side begins there
    const Vec3& origin = mesh.points_mm[f[at]];
    const Corners of_f = seen(mesh, f, origin), of_g = seen(mesh, g, origin);
    if (common == 0) return apart_from(of_f, of_g) || apart_from(of_g, of_f) || apart_along_sides(of_f, of_g);
    const std::size_t there = place_in(g, f[at]);
    if (common == 1) return sectors_apart(of_f[(at + 1) % 3], of_f[(at + 2) % 3], of_g[(there + 1) % 3], of_g[(there + 2) % 3]);
    const bool opposed = common == 2 && f[(at + 1) % 3] == g[(there + 2) % 3];  // the common side runs to and fro
    return opposed && unfolded(of_f[(at + 1) % 3], of_f[(at + 2) % 3], of_g[(there + 1) % 3]);
}

std::optional<std::vector<std::uint32_t>> doubtful_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& left_out,
                                                             std::size_t most_pairs) {
    std::vector<bool> doubtful(mesh.triangles.size());
    const NearPairs near(mesh, left_out);
    for (const FaceBox& box : near.boxes()) doubtful[box.triangle] = without_area(mesh, mesh.triangles[box.triangle]);
    std::size_t pairs = 0;
    const auto judge = [&](std::uint32_t a, std::uint32_t b) {
        if (++pairs > most_pairs) throw TooMany();
        if (core::interrupted()) throw core::Stopped();
        if (!surely_apart(mesh, mesh.triangles[a], mesh.triangles[b])) doubtful[a] = doubtful[b] = true;
    };
    try {
        near.for_each(judge);
    } catch (const TooMany&) {
        return std::nullopt;
    }
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < doubtful.size(); ++i)
        if (doubtful[i]) numbers.push_back(i);
    return numbers;
}

std::vector<std::uint32_t> doubtful_triangles(const Mesh& mesh) {
    return *doubtful_triangles(mesh, {}, std::numeric_limits<std::size_t>::max());
}

}  // namespace fusee::solid
