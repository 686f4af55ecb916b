#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <utility>
#include <vector>

#include "fusee/core/progress.h"
#include "fusee/core/units.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/mesh_faults.h"

namespace fusee::solid {

namespace {

/// A triangle's bounding box in single precision: too large by rounding, never too small.
struct FaceBox {
    std::array<float, 3> low, high;
    std::uint32_t triangle = 0;
};

/// Which bounding boxes of a mesh's triangles meet: a binary tree over the boxes along a Morton curve, led against itself. Each node's box
/// is joined from those below, so the tree costs little more than one sort.
class NearPairs {
public:
    /// @param left_out triangles, rising
    NearPairs(const Mesh& mesh, const std::vector<std::uint32_t>& left_out);

    [[nodiscard]] const std::vector<FaceBox>& boxes() const { return boxes_; }
    /// Calls `visit` with the two triangles of each pair, once.
    template <class Visit>
    void for_each(const Visit& visit) const {
        if (!boxes_.empty()) within(levels_.size() - 1, 0, visit);
    }

private:
    static constexpr std::size_t kLeaf = 4;
    struct Node {
        std::array<float, 3> low, high;
    };

    template <class A, class B>
    static bool meet(const A& a, const B& b) {  // without branches
        int apart = 0;
        for (std::size_t k = 0; k < 3; ++k) apart |= int{a.low[k] > b.high[k]} | int{b.low[k] > a.high[k]};
        return apart == 0;
    }
    [[nodiscard]] std::pair<std::size_t, std::size_t> leaf(std::size_t i) const {
        return {i * kLeaf, std::min((i + 1) * kLeaf, boxes_.size())};
    }
    template <class Visit>
    void within(std::size_t level, std::size_t i, const Visit& visit) const {
        if (level > 0) {
            within(level - 1, 2 * i, visit);
            if (2 * i + 1 == levels_[level - 1].size()) return;
            within(level - 1, 2 * i + 1, visit);
            across(level - 1, 2 * i, 2 * i + 1, visit);
            return;
        }
        const auto [begin, end] = leaf(i);
        for (std::size_t a = begin; a < end; ++a)
            for (std::size_t b = a + 1; b < end; ++b)
                if (meet(boxes_[a], boxes_[b])) visit(boxes_[a].triangle, boxes_[b].triangle);
    }
    template <class Visit>
    void across(std::size_t level, std::size_t i, std::size_t k, const Visit& visit) const {
        if (!meet(levels_[level][i], levels_[level][k])) return;
        if (level > 0) {
            const std::size_t count = levels_[level - 1].size();
            for (std::size_t a = 2 * i; a < std::min(2 * i + 2, count); ++a)
                for (std::size_t b = 2 * k; b < std::min(2 * k + 2, count); ++b) across(level - 1, a, b, visit);
            return;
        }
        const auto [begin, end] = leaf(i);
        const auto [first, last] = leaf(k);
        for (std::size_t a = begin; a < end; ++a) {
            if (!meet(boxes_[a], levels_[0][k])) continue;
            for (std::size_t b = first; b < last; ++b)
                if (meet(boxes_[a], boxes_[b])) visit(boxes_[a].triangle, boxes_[b].triangle);
        }
    }

    std::vector<FaceBox> boxes_;             ///< along the curve
    std::vector<std::vector<Node>> levels_;  ///< the leaves first, of kLeaf boxes each; every other node holds two
};

constexpr double kSingle = 1.3e-7;  // more than the rounding to single precision
constexpr int kBits = 10;           // of a coordinate on the curve: a cell of a thousandth of the mesh

FaceBox face_box(const Mesh& mesh, std::uint32_t triangle) {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    FaceBox box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}, triangle};
    for (const std::uint32_t v : mesh.triangles[triangle])
        for (std::size_t k = 0; k < 3; ++k) {
            const double at = mesh.points_mm[v][k], margin = kSingle * std::abs(at);
            box.low[k] = std::min(box.low[k], static_cast<float>(at - margin));
            box.high[k] = std::max(box.high[k], static_cast<float>(at + margin));
        }
    return box;
}

/// The bits of a coordinate, each before two zeros.
std::uint64_t every_third_bit(std::uint64_t x) {
    x = (x | x << 16U) & 0x30000ffU;
    x = (x | x << 8U) & 0x300f00fU;
    x = (x | x << 4U) & 0x30c30c3U;
    return (x | x << 2U) & 0x9249249U;
}

/// The boxes' numbers along a Morton curve.
std::vector<std::uint64_t> along_curve(const std::vector<FaceBox>& boxes, const Box& all) {
    std::array<double, 3> scale{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double extent = all.high_mm[k] - all.low_mm[k];
        scale[k] = extent > 0.0 ? 0.5 * ((1 << kBits) - 1) / extent : 0.0;
    }
    std::vector<std::uint64_t> order;
    order.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        std::uint64_t place = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double twice = double(boxes[i].low[k]) - all.low_mm[k] + (double(boxes[i].high[k]) - all.low_mm[k]);
            const double cell = std::clamp(scale[k] * twice, 0.0, double((1 << kBits) - 1));
            place |= every_third_bit(static_cast<std::uint64_t>(cell)) << k;
        }
        order.push_back(place << 32U | i);
    }
    std::sort(order.begin(), order.end());
    return order;
}

NearPairs::NearPairs(const Mesh& mesh, const std::vector<std::uint32_t>& left_out) {
    std::vector<FaceBox> boxes;
    boxes.reserve(mesh.triangles.size() - left_out.size());
    auto skip = left_out.begin();
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        if (skip != left_out.end() && *skip == i)
            ++skip;
        else
            boxes.push_back(face_box(mesh, i));
    if (boxes.empty()) return;
    boxes_.reserve(boxes.size());
    for (const std::uint64_t place : along_curve(boxes, bounding_box(mesh))) boxes_.push_back(boxes[place & 0xffffffffU]);
    const auto join = [](Node& into, const auto& box) {
        for (std::size_t k = 0; k < 3; ++k)
            into.low[k] = std::min(into.low[k], box.low[k]), into.high[k] = std::max(into.high[k], box.high[k]);
    };
    const auto level_of = [&join](const auto& below, std::size_t each) {
        std::vector<Node> level;
        level.reserve(below.size() / each + 1);
        for (std::size_t i = 0; i < below.size(); ++i) {
            if (i % each == 0) level.push_back({below[i].low, below[i].high});
            join(level.back(), below[i]);
        }
        return level;
    };
    levels_.push_back(level_of(boxes_, kLeaf));
    while (levels_.back().size() > 1) levels_.push_back(level_of(levels_.back(), 2));
}

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
