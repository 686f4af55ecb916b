#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::inspect {

/// A box around triangles, and the slabs that bound it. Axes, unit to single precision, need not be orthogonal for the slabs to hold the
/// triangles: `low` and `high` are measured along the axes as they are stored, and lie outside by kMargin of the farthest coordinate.
struct OrientedBox {
    std::array<std::array<float, 3>, 3> axis;
    std::array<float, 3> low, high;
    std::uint32_t next = 0;  ///< the second child, the first one follows; a leaf: kLeaf | first triangle << 3 | triangles - 1
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

    [[nodiscard]] const std::vector<OrientedBox>& boxes() const { return boxes_; }               ///< the root first
    [[nodiscard]] const std::vector<solid::Triangle>& corners() const { return corners_; }       ///< in the order of the leaves
    [[nodiscard]] const std::vector<std::uint32_t>& numbers() const { return numbers_; }         ///< of these triangles in the mesh
    [[nodiscard]] const std::vector<solid::Vec3>& points_mm() const { return points_; }          ///< of the mesh

private:
    std::vector<OrientedBox> boxes_;
    std::vector<solid::Triangle> corners_;
    std::vector<std::uint32_t> numbers_;
    std::vector<solid::Vec3> points_;
};

}  // namespace fusee::inspect
