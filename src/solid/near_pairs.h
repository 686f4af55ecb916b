#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

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

}  // namespace fusee::solid
