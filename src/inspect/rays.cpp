#include <algorithm>

#include "fusee/inspect/body.h"
#include "fusee/inspect/topology.h"
#include "oriented_tree.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

thread_local std::size_t t_visited = 0;

constexpr std::size_t kDeepest = 64;     // of the tree, whose halves have the same number of triangles
constexpr double kNearerBox = 1 - 1e-5;  // the axes of a box are a frame to single precision only
constexpr float kNearer = 1 - 1e-6F;     // a distance to a slab, rounded
constexpr double kFarthest = std::numeric_limits<float>::max();

std::array<float, 3> in_single(const Vec3& p) { return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}; }
/// What the sums of a box lose in single precision for this place; the box's own margin is for the places of the mesh.
float rounding_at(const Vec3& p) { return static_cast<float>(1e-6 * (std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]))); }

/// The point of a triangle with an area nearest to p (C. Ericson, "Real-Time Collision Detection", 2005, 5.1.5).
Vec3 nearest_of(const std::array<Vec3, 3>& t, const Vec3& p) {
    const auto& [a, b, c] = t;
    const Vec3 ab = b - a, ac = c - a;
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

/// A ray in a frame where it runs along z from the origin (S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2
/// (2013)): an edge is on the same side of the ray for both of its triangles, so that no ray passes between them.
class Ray {
public:
    Ray(const Vec3& from, const Vec3& direction) : from_(from) {
        for (const std::size_t i : {1U, 2U})
            if (std::abs(direction[i]) > std::abs(direction[z_])) z_ = i;
        x_ = (z_ + 1) % 3, y_ = (z_ + 2) % 3;
        shear_x_ = direction[x_] / direction[z_], shear_y_ = direction[y_] / direction[z_], scale_ = 1.0 / direction[z_];
        at_ = in_single(from), way_ = in_single(direction), slack_ = rounding_at(from);
    }

    /// Distance to the triangle, NaN where the ray misses it. Edges belong to it.
    [[nodiscard]] double meets(const std::array<Vec3, 3>& t) const {
        const Vec3 a = t[0] - from_, b = t[1] - from_, c = t[2] - from_;
        const double ax = a[x_] - shear_x_ * a[z_], ay = a[y_] - shear_y_ * a[z_];
        const double bx = b[x_] - shear_x_ * b[z_], by = b[y_] - shear_y_ * b[z_];
        const double cx = c[x_] - shear_x_ * c[z_], cy = c[y_] - shear_y_ * c[z_];
        const double u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
        if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return NAN;
        const double sum = u + v + w;
        if (sum == 0.0) return meets_within({{{ax, ay, a[z_]}, {bx, by, b[z_]}, {cx, cy, c[z_]}}});
        const double distance = scale_ * (u * a[z_] + v * b[z_] + w * c[z_]) / sum;
        return distance >= 0.0 ? distance : NAN;
    }

    /// A bound from below of the distance to where the ray enters the box; above `most` if it does not up to there.
    [[nodiscard]] double enters(const OrientedBox& box, double most) const {
        constexpr float kLevel = 1e-20F;  // a ray along a slab
        const Lanes from = box.along(at_[0], at_[1], at_[2]), steep = box.along(way_[0], way_[1], way_[2]);
        const Lanes speed = 1.0F / (steep > kLevel || steep < -kLevel ? steep : Lanes{} + kLevel);
        const Lanes low = (box.lows() - slack_ - from) * speed, high = (box.highs() + slack_ - from) * speed;
        const Lanes first = low < high ? low : high, last = low < high ? high : low;
        const float enter = kNearer * std::max({first[0], first[1], first[2], 0.0F});
        const float leave = std::min({last[0], last[1], last[2], static_cast<float>(std::min(most, kFarthest))});
        return enter <= leave ? static_cast<double>(enter) : INFINITY;
    }

private:
    /// In the triangle's own plane, the distance to where the ray enters it, 0 where it starts in it. Seen along the ray the triangle is a
    /// segment.
    [[nodiscard]] double meets_within(const std::array<Vec3, 3>& seen) const {
        const auto wide = [&seen](std::size_t k) { return std::max({std::abs(seen[0][k]), std::abs(seen[1][k]), std::abs(seen[2][k])}); };
        const std::size_t k = wide(0) > wide(1) ? 0 : 1;
        double enter = INFINITY, leave = -INFINITY;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 &p = seen[i], &q = seen[(i + 1) % 3];
            if ((p[k] > 0.0 && q[k] > 0.0) || (p[k] < 0.0 && q[k] < 0.0)) continue;
            const double at_p = p[k] == q[k] ? p[2] : p[2] + (q[2] - p[2]) * (p[k] / (p[k] - q[k])), at_q = p[k] == q[k] ? q[2] : at_p;
            enter = std::min({enter, scale_ * at_p, scale_ * at_q}), leave = std::max({leave, scale_ * at_p, scale_ * at_q});
        }
        return leave >= 0.0 ? std::max(enter, 0.0) : NAN;
    }

    Vec3 from_;
    std::size_t x_ = 0, y_ = 0, z_ = 0;
    double shear_x_ = 0.0, shear_y_ = 0.0, scale_ = 0.0;
    std::array<float, 3> at_{}, way_{};
    float slack_ = 0.0F;
};

/// Bounds of the distance's square from below.
class Place {
public:
    explicit Place(const Vec3& p) : at_(in_single(p)), slack_(rounding_at(p)) {}
    [[nodiscard]] double from(const OrientedBox& box) const {
        const Lanes s = box.along(at_[0], at_[1], at_[2]), under = box.lows() - s, over = s - box.highs();
        Lanes out = (under > over ? under : over) - slack_;
        out = out > 0.0F ? out * out : Lanes{};
        return kNearerBox * static_cast<double>(out[0] + out[1] + out[2]);
    }

private:
    std::array<float, 3> at_;
    float slack_;
};

/// Boxes that are still to be opened, the nearest first among the two of a parent.
class Waiting {
public:
    struct Item {
        std::uint32_t box;
        double key;
    };
    void push(std::uint32_t box, double key) { items_[count_++] = {box, key}; }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    Item pop() { return items_[--count_]; }

private:
    std::array<Item, kDeepest> items_;
    std::size_t count_ = 0;
};

/// Calls `visit` with the place of each triangle in a box whose key is at most `most()`, boxes with a smaller key first.
template <class Key, class Most, class Visit>
void descend(const OrientedTree& tree, const Key& key_of, const Most& most, const Visit& visit) {
    if (tree.boxes().empty()) return;
    Waiting waiting;
    waiting.push(0, key_of(tree.boxes()[0]));
    while (!waiting.empty()) {
        auto [number, key] = waiting.pop();
        while (key <= most()) {
            const OrientedBox& box = tree.boxes()[number];
            if (box.next & OrientedTree::kLeaf) {
                const std::size_t first = (box.next & ~OrientedTree::kLeaf) >> 3U, count = (box.next & 7U) + 1;
                t_visited += count;
                for (std::size_t i = first; i < first + count; ++i) visit(i);
                break;
            }
            std::uint32_t near = number + 1, far = box.next;
            double near_key = key_of(tree.boxes()[near]), far_key = key_of(tree.boxes()[far]);
            if (far_key < near_key) std::swap(near, far), std::swap(near_key, far_key);
            if (far_key <= most()) waiting.push(far, far_key);
            number = near, key = near_key;
        }
    }
}

}  // namespace

struct Rays::Tree {
    OrientedTree boxes;

    [[nodiscard]] std::array<Vec3, 3> triangle(std::size_t place) const {
        const solid::Triangle& t = boxes.corners()[place];
        const auto& p = boxes.points_mm();
        return {p[t[0]], p[t[1]], p[t[2]]};
    }
};

Rays::Rays(const solid::Mesh& mesh, unsigned jobs) {
    std::vector<std::uint32_t> with_area;
    with_area.reserve(mesh.triangles.size());
    const std::vector<std::uint32_t> flat = flat_triangles(mesh);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (!std::binary_search(flat.begin(), flat.end(), t)) with_area.push_back(t);
    tree_ = std::make_unique<Tree>(Tree{OrientedTree(mesh, std::move(with_area), jobs)});
}
Rays::~Rays() = default;
Rays::Rays(Rays&&) noexcept = default;
Rays& Rays::operator=(Rays&&) noexcept = default;

bool Rays::empty() const { return tree_->boxes.boxes().empty(); }

std::optional<Hit> Rays::first(const Vec3& from, const Vec3& direction, std::uint32_t skip) const {
    const Ray ray(from, direction);
    Hit best{kNone, INFINITY};
    descend(
        tree_->boxes, [&](const OrientedBox& box) { return ray.enters(box, best.distance_mm); },
        [&] { return best.distance_mm < INFINITY ? best.distance_mm : std::numeric_limits<double>::max(); },
        [&](std::size_t place) {
            const std::uint32_t number = tree_->boxes.numbers()[place];
            const double distance = number == skip ? NAN : ray.meets(tree_->triangle(place));
            if (distance < best.distance_mm || (distance == best.distance_mm && number < best.triangle)) best = {number, distance};
        });
    return best.triangle == kNone ? std::nullopt : std::optional(best);
}

std::vector<std::uint32_t> Rays::all(const Vec3& from, const Vec3& direction) const {
    const Ray ray(from, direction);
    constexpr double kEverywhere = std::numeric_limits<double>::max();
    std::vector<std::uint32_t> numbers;
    descend(
        tree_->boxes, [&](const OrientedBox& box) { return ray.enters(box, kEverywhere); }, [&] { return kEverywhere; },
        [&](std::size_t place) {
            if (!std::isnan(ray.meets(tree_->triangle(place)))) numbers.push_back(tree_->boxes.numbers()[place]);
        });
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

std::optional<std::pair<Vec3, std::uint32_t>> Rays::nearest(const Vec3& at, double within_mm) const {
    const Place place_of_at(at);
    double best = within_mm * within_mm;
    std::pair<Vec3, std::uint32_t> found{{}, kNone};
    descend(
        tree_->boxes, [&](const OrientedBox& box) { return place_of_at.from(box); }, [&] { return best; },
        [&](std::size_t place) {
            const Vec3 q = nearest_of(tree_->triangle(place), at);
            const double square = dot(q - at, q - at);
            const std::uint32_t number = tree_->boxes.numbers()[place];
            if (square < best || (square == best && number < found.second && found.second != kNone)) best = square, found = {q, number};
        });
    return found.second == kNone ? std::nullopt : std::optional(found);
}

std::size_t Rays::visited() { return t_visited; }

}  // namespace fusee::inspect
