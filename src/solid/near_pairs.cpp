#include "near_pairs.h"

#include <cmath>

namespace fusee::solid {

namespace {

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

}  // namespace

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

}  // namespace fusee::solid
