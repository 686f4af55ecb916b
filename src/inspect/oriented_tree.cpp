#include "oriented_tree.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "fusee/core/parallel.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

constexpr double kMargin = 4e-6;            // of the farthest coordinate: beyond what sums in single precision lose, here and in a query
constexpr std::size_t kMostOriented = 512;  // triangles of a box with axes of its own; a larger box lies along x, y and z
constexpr std::size_t kMostForAxes = 64;    // triangles that give a box its axes; a larger box takes every n-th
constexpr std::size_t kShares = 64;         // subtrees that are built side by side

struct Extent {
    Lanes low{INFINITY, INFINITY, INFINITY, INFINITY}, high = -low;
    void add(const Lanes& at) { add({at, at}); }
    void add(const Extent& other) {
        low = other.low < low ? other.low : low;
        high = other.high > high ? other.high : high;
    }
};

class Builder {
public:
    Builder(const std::vector<Vec3>& points, const std::vector<solid::Triangle>& triangles, std::vector<std::uint32_t>& order)
        : points_(points), triangles_(triangles), order_(order) {
        double farthest = 0.0;
        for (const Vec3& p : points)
            for (const double x : p) farthest = std::max(farthest, std::abs(x));
        margin_ = static_cast<float>(kMargin * farthest);
    }

    /// Puts the triangles of each half together, and returns where the second one begins. Halves along the axis of the box along which the
    /// middles are spread most.
    std::size_t divide(std::size_t first, std::size_t end, const OrientedBox& box) {
        const std::size_t count = end - first, middle = count / 2;
        std::vector<Lanes> at(count);
        Extent extent;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 m = thrice_middle(order_[first + i]);
            extent.add(at[i] = box.along(static_cast<float>(m[0]), static_cast<float>(m[1]), static_cast<float>(m[2])));
        }
        const Lanes size = extent.high - extent.low;
        const int longest = size[1] > size[0] ? (size[2] > size[1] ? 2 : 1) : (size[2] > size[0] ? 2 : 0);
        std::vector<std::pair<float, std::uint32_t>> keys(count);
        for (std::size_t i = 0; i < count; ++i) keys[i] = {float{at[i][longest]}, order_[first + i]};
        std::nth_element(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(middle), keys.end());
        for (std::size_t i = 0; i < count; ++i) order_[first + i] = keys[i].second;
        return first + middle;
    }

    /// @returns the extent along x, y and z
    Extent build(std::size_t first, std::size_t end, std::vector<OrientedBox>& into) {
        const std::size_t here = into.size(), count = end - first;
        into.push_back(count > kMostOriented ? upright() : oriented(first, end));
        if (count <= OrientedTree::kMostInLeaf) {
            into[here].next = OrientedTree::kLeaf | static_cast<std::uint32_t>(first << 3U) | static_cast<std::uint32_t>(count - 1);
            return extent(first, end, upright());
        }
        const std::size_t middle = divide(first, end, into[here]);
        Extent all = build(first, middle, into);
        into[here].next = static_cast<std::uint32_t>(into.size());
        all.add(build(middle, end, into));
        if (count > kMostOriented) bound(into[here], all);
        return all;
    }

    /// A box along x, y and z, without its extent.
    static OrientedBox upright() { return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}, {}}; }

    void bound(OrientedBox& box, const Extent& extent) const {
        for (std::size_t k = 0; k < 3; ++k) box.low[k] = extent.low[k] - margin_, box.high[k] = extent.high[k] + margin_;
    }

private:
    [[nodiscard]] Vec3 thrice_middle(std::uint32_t t) const {
        const solid::Triangle& c = triangles_[t];
        return points_[c[0]] + points_[c[1]] + points_[c[2]];
    }
    [[nodiscard]] Extent extent(std::size_t first, std::size_t end, const OrientedBox& box) const {
        Extent extent;
        for (std::size_t i = first; i < end; ++i)
            for (const std::uint32_t c : triangles_[order_[i]]) {
                const Vec3& p = points_[c];
                extent.add(box.along(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])));
            }
        return extent;
    }

    /// Along the principal axes of the surface: second moments of the triangles by their areas.
    [[nodiscard]] OrientedBox oriented(std::size_t first, std::size_t end) const {
        const std::size_t step = (end - first - 1) / kMostForAxes + 1;
        Vec3 middle{};
        double area = 0.0;
        for (std::size_t i = first; i < end; i += step) {
            const double a = twice_area(order_[i]);
            middle = middle + a / 3.0 * thrice_middle(order_[i]);
            area += a;
        }
        middle = 1.0 / area * middle;
        Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();  // below the diagonal
        for (std::size_t i = first; i < end; i += step) {
            const double a = twice_area(order_[i]) / area;
            Vec3 sum{};
            for (const std::uint32_t p : triangles_[order_[i]]) {
                const Vec3 q = points_[p] - middle;
                sum = sum + q;
                add(moments, a, q);
            }
            add(moments, a, sum);
        }
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
        solver.computeDirect(moments / moments.trace());
        OrientedBox box = upright();
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 3; ++i)
                box.axis[i][k] = static_cast<float>(solver.eigenvectors()(static_cast<int>(i), static_cast<int>(k)));
        if (!sound(box)) box = upright();
        bound(box, extent(first, end, box));
        return box;
    }
    /// Whether the axes are a frame within single precision; moments of a point or a tiny triangle give none.
    static bool sound(const OrientedBox& box) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Lanes products = box.along(box.axis[0][i], box.axis[1][i], box.axis[2][i]);
            for (std::size_t k = i; k < 3; ++k)
                if (!(std::abs(products[k] - (i == k ? 1.0F : 0.0F)) < 2e-6F)) return false;
        }
        return true;
    }
    static void add(Eigen::Matrix3d& moments, double weight, const Vec3& q) {
        const Vec3 w = weight * q;
        moments(0, 0) += w[0] * q[0];
        moments(1, 0) += w[1] * q[0], moments(1, 1) += w[1] * q[1];
        moments(2, 0) += w[2] * q[0], moments(2, 1) += w[2] * q[1], moments(2, 2) += w[2] * q[2];
    }
    [[nodiscard]] double twice_area(std::uint32_t t) const {
        const solid::Triangle& c = triangles_[t];
        return length(cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]]));
    }

    const std::vector<Vec3>& points_;
    const std::vector<solid::Triangle>& triangles_;
    std::vector<std::uint32_t>& order_;
    float margin_ = 0.0F;
};

/// The top of the tree divides the triangles into shares of one size; each share becomes a subtree of its own.
class Top {
public:
    Top(Builder& builder, std::size_t count, unsigned jobs) : builder_(builder), jobs_(jobs) {
        nodes_.push_back({0, count});
        while (nodes_.size() < 2 * kShares - 1 && nodes_[begin_].size() > 16 * OrientedTree::kMostInLeaf) divide_level();
        subtrees_.resize(nodes_.size() - begin_);
        core::parallel_for(subtrees_.size(), jobs_, [this](std::size_t i) {
            Range& share = nodes_[begin_ + i];
            share.extent = builder_.build(share.first, share.end, subtrees_[i]);
        });
        for (std::size_t i = begin_; i-- > 0;) {
            nodes_[i].extent = nodes_[2 * i + 1].extent;
            nodes_[i].extent.add(nodes_[2 * i + 2].extent);
        }
    }
    std::vector<OrientedBox> joined() {
        std::vector<OrientedBox> all;
        std::size_t boxes = begin_;
        for (const auto& subtree : subtrees_) boxes += subtree.size();
        all.reserve(boxes);
        join(0, all);
        return all;
    }

private:
    struct Range {
        std::size_t first = 0, end = 0, middle = 0;
        Extent extent{};
        [[nodiscard]] std::size_t size() const { return end - first; }
    };
    void divide_level() {
        const std::size_t level = nodes_.size() - begin_, begin = begin_;
        core::parallel_for(level, jobs_, [&](std::size_t i) {
            Range& range = nodes_[begin + i];
            range.middle = builder_.divide(range.first, range.end, Builder::upright());
        });
        begin_ = nodes_.size();
        for (std::size_t i = 0; i < level; ++i) {
            const Range range = nodes_[begin + i];
            nodes_.push_back({range.first, range.middle});
            nodes_.push_back({range.middle, range.end});
        }
    }
    void join(std::size_t node, std::vector<OrientedBox>& all) {
        const std::size_t here = all.size();
        if (node >= begin_) {
            for (OrientedBox box : subtrees_[node - begin_]) {
                if (!(box.next & OrientedTree::kLeaf)) box.next += static_cast<std::uint32_t>(here);
                all.push_back(box);
            }
            subtrees_[node - begin_] = {};
            return;
        }
        all.push_back(Builder::upright());
        builder_.bound(all[here], nodes_[node].extent);
        join(2 * node + 1, all);
        all[here].next = static_cast<std::uint32_t>(all.size());
        join(2 * node + 2, all);
    }

    Builder& builder_;
    unsigned jobs_;
    std::vector<Range> nodes_;  ///< a heap: the children of i are 2 i + 1 and 2 i + 2
    std::size_t begin_ = 0;     ///< of the last level
    std::vector<std::vector<OrientedBox>> subtrees_;
};

}  // namespace

OrientedTree::OrientedTree(const solid::Mesh& mesh, std::vector<std::uint32_t> triangles, unsigned jobs)
    : numbers_(std::move(triangles)), points_(mesh.points_mm) {
    if (numbers_.empty()) return;
    Builder builder(points_, mesh.triangles, numbers_);
    boxes_ = Top(builder, numbers_.size(), jobs).joined();
    corners_.reserve(numbers_.size());
    for (const std::uint32_t t : numbers_) corners_.push_back(mesh.triangles[t]);
}

}  // namespace fusee::inspect
