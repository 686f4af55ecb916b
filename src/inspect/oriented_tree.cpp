#include "oriented_tree.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "fusee/core/parallel.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

constexpr double kMargin = 2.5e-7;         // of the farthest coordinate: twice the rounding to single precision
constexpr std::size_t kMostForAxes = 256;  // triangles that give a box its axes; a larger box takes every n-th
constexpr std::size_t kShares = 64;        // subtrees that are built side by side

using Axes = std::array<std::array<float, 3>, 3>;

double along(const std::array<float, 3>& axis, const Vec3& p) { return axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2]; }

class Builder {
public:
    Builder(const std::vector<Vec3>& points, const std::vector<solid::Triangle>& triangles, std::vector<std::uint32_t>& order)
        : points_(points), triangles_(triangles), order_(order) {
        double farthest = 0.0;
        for (const Vec3& p : points)
            for (const double x : p) farthest = std::max(farthest, std::abs(x));
        margin_ = kMargin * farthest;
    }

    /// Puts the triangles of each half together, and returns where the second one begins.
    std::size_t divide(std::size_t first, std::size_t end, const Axes& axes) {
        const std::size_t middle = first + (end - first) / 2;
        const auto& axis = axes[longest(first, end, axes)];
        std::vector<std::pair<double, std::uint32_t>> keys(end - first);
        for (std::size_t i = first; i < end; ++i) keys[i - first] = {along(axis, thrice_middle(order_[i])), order_[i]};
        std::nth_element(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(middle - first), keys.end());
        for (std::size_t i = first; i < end; ++i) order_[i] = keys[i - first].second;
        return middle;
    }

    void build(std::size_t first, std::size_t end, std::vector<OrientedBox>& into) {
        const std::size_t here = into.size();
        into.push_back(box(first, end));
        if (end - first <= OrientedTree::kMostInLeaf) {
            into[here].next = OrientedTree::kLeaf | static_cast<std::uint32_t>(first << 3U) | static_cast<std::uint32_t>(end - first - 1);
            return;
        }
        const std::size_t middle = divide(first, end, into[here].axis);
        build(first, middle, into);
        into[here].next = static_cast<std::uint32_t>(into.size());
        build(middle, end, into);
    }

    [[nodiscard]] OrientedBox box(std::size_t first, std::size_t end) const {
        OrientedBox box;
        box.axis = axes(first, end);
        std::array<double, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
        for (std::size_t i = first; i < end; ++i)
            for (const std::uint32_t p : triangles_[order_[i]])
                for (std::size_t k = 0; k < 3; ++k) {
                    const double x = along(box.axis[k], points_[p]);
                    low[k] = std::min(low[k], x), high[k] = std::max(high[k], x);
                }
        for (std::size_t k = 0; k < 3; ++k)
            box.low[k] = static_cast<float>(low[k] - margin_), box.high[k] = static_cast<float>(high[k] + margin_);
        return box;
    }

private:
    [[nodiscard]] Vec3 thrice_middle(std::uint32_t t) const {
        const solid::Triangle& c = triangles_[t];
        return points_[c[0]] + points_[c[1]] + points_[c[2]];
    }

    /// Along which the middles are spread most.
    [[nodiscard]] std::size_t longest(std::size_t first, std::size_t end, const Axes& axes) const {
        std::array<double, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
        for (std::size_t i = first; i < end; ++i) {
            const Vec3 m = thrice_middle(order_[i]);
            for (std::size_t k = 0; k < 3; ++k) {
                const double x = along(axes[k], m);
                low[k] = std::min(low[k], x), high[k] = std::max(high[k], x);
            }
        }
        std::size_t best = 0;
        for (const std::size_t k : {1U, 2U})
            if (high[k] - low[k] > high[best] - low[best]) best = k;
        return best;
    }

    /// Principal axes of the surface: second moments of the triangles by their areas.
    [[nodiscard]] Axes axes(std::size_t first, std::size_t end) const {
        const std::size_t step = (end - first - 1) / kMostForAxes + 1;
        Vec3 middle{};
        double area = 0.0;
        for (std::size_t i = first; i < end; i += step) {
            const double a = twice_area(order_[i]);
            middle = middle + a / 3.0 * thrice_middle(order_[i]);
            area += a;
        }
        middle = 1.0 / area * middle;
        Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
        for (std::size_t i = first; i < end; i += step) {
            const solid::Triangle& c = triangles_[order_[i]];
            const double a = twice_area(order_[i]) / area;
            Vec3 sum{};
            for (const std::uint32_t p : c) {
                const Vec3 q = points_[p] - middle;
                sum = sum + q;
                add(moments, a, q);
            }
            add(moments, a, sum);
        }
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
        solver.computeDirect(moments / moments.trace());
        Axes axes;
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 3; ++i)
                axes[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)] = static_cast<float>(solver.eigenvectors()(i, k));
        return sound(axes) ? axes : Axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    }
    /// Whether the axes are a frame within single precision; moments of a point or a tiny triangle give none.
    static bool sound(const Axes& axes) {
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = i; k < 3; ++k) {
                const double product = along(axes[i], {axes[k][0], axes[k][1], axes[k][2]});
                if (!(std::abs(product - (i == k ? 1.0 : 0.0)) < 1e-6)) return false;
            }
        return true;
    }
    static void add(Eigen::Matrix3d& moments, double weight, const Vec3& q) {
        const Eigen::Map<const Eigen::Vector3d> v(q.data());
        moments += weight * v * v.transpose();
    }
    [[nodiscard]] double twice_area(std::uint32_t t) const {
        const solid::Triangle& c = triangles_[t];
        return length(cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]]));
    }

    const std::vector<Vec3>& points_;
    const std::vector<solid::Triangle>& triangles_;
    std::vector<std::uint32_t>& order_;
    double margin_ = 0.0;
};

/// The top of the tree divides the triangles into shares of one size; each share becomes a subtree of its own.
class Top {
public:
    Top(Builder& builder, std::size_t count, unsigned jobs) : builder_(builder), jobs_(jobs) {
        nodes_.push_back({0, count});
        while (nodes_.size() < 2 * kShares - 1 && nodes_[begin_].size() > 16 * OrientedTree::kMostInLeaf) divide_level();
        subtrees_.resize(nodes_.size() - begin_);
        core::parallel_for(subtrees_.size(), jobs_, [this](std::size_t i) {
            const Range& share = nodes_[begin_ + i];
            builder_.build(share.first, share.end, subtrees_[i]);
        });
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
        OrientedBox box{};
        [[nodiscard]] std::size_t size() const { return end - first; }
    };
    void divide_level() {
        const std::size_t level = nodes_.size() - begin_, begin = begin_;
        core::parallel_for(level, jobs_, [&](std::size_t i) {
            Range& range = nodes_[begin + i];
            range.box = builder_.box(range.first, range.end);
            range.middle = builder_.divide(range.first, range.end, range.box.axis);
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
        all.push_back(nodes_[node].box);
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
