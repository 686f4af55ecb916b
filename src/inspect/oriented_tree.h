#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::inspect {

/// A figure for each of three axes; the fourth lane has no meaning. GCC's vector extension: one register of SSE2.
using Lanes = float __attribute__((vector_size(16)));

/// A box around triangles, and the slabs that bound it. Axes, unit to single precision, need not be orthogonal for the slabs to hold the
/// triangles: `low` and `high` lie outside by kMargin of the farthest coordinate.
struct OrientedBox {
    std::array<std::array<float, 3>, 3> axis;  ///< by coordinate: axis[i][k] is the coordinate i of axis k
    std::array<float, 3> low, high;
    std::uint32_t next = 0;  ///< the second child, the first one follows; a leaf: kLeaf | first triangle << 3 | triangles - 1

    /// a x + b y + c z for each axis, with the same three figures for all.
    [[nodiscard]] Lanes along(float x, float y, float z) const { return x * row(0) + y * row(3) + z * row(6); }
    [[nodiscard]] Lanes lows() const { return row(9); }
    [[nodiscard]] Lanes highs() const {  // without `next`, whose bits are no figure
        const Lanes from_before = row(11);
        return __builtin_shufflevector(from_before, from_before, 1, 2, 3, 3);
    }

private:
    /// Four floats from the `first` one of the box.
    [[nodiscard]] Lanes row(std::size_t first) const {
        Lanes lanes;
        std::memcpy(&lanes, reinterpret_cast<const char*>(this) + first * sizeof(float), sizeof lanes);
        return lanes;
    }
};
static_assert(sizeof(OrientedBox) == 64);

/// A binary tree of oriented boxes (S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", SIGGRAPH 1996). A mesh of a cam has triangles a
/// thousand times as long as wide, in every direction: boxes along x, y and z overlap there by hundreds, boxes along the triangles do not.
class OrientedTree {
public:
    static constexpr std::uint32_t kLeaf = 1U << 31;
    static constexpr std::uint32_t kMostInLeaf = 4;

    /// @param jobs threads; the tree does not depend on them @pre fewer than 2^28 triangles
    OrientedTree(const solid::Mesh& mesh, std::vector<std::uint32_t> triangles, unsigned jobs);

    [[nodiscard]] const std::vector<OrientedBox>& boxes() const { return boxes_; }          ///< the root first
    [[nodiscard]] const std::vector<solid::Triangle>& corners() const { return corners_; }  ///< in the order of the leaves
    [[nodiscard]] const std::vector<std::uint32_t>& numbers() const { return numbers_; }    ///< of these triangles in the mesh
    [[nodiscard]] const std::vector<solid::Vec3>& points_mm() const { return points_; }     ///< of the mesh

private:
    std::vector<OrientedBox> boxes_;
    std::vector<solid::Triangle> corners_;
    std::vector<std::uint32_t> numbers_;
    std::vector<solid::Vec3> points_;
};

}  // namespace fusee::inspect
