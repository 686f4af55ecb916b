#pragma once
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

/// Solids of a STEP file on straight paths, by pictures of their depth: shares nothing with module assembly.
namespace fusee::step_geometry {

using Corners = std::array<Eigen::Vector3d, 3>;
struct Solid {
    std::vector<Corners> triangles;  ///< of its surface, within 0.02 mm
    Eigen::AlignedBox3d box;
};

inline std::vector<Solid> solids_of(const TopoDS_Shape& shape) {
    BRepMesh_IncrementalMesh(shape, 0.02, false, 0.2);
    std::vector<Solid> all;
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
        Solid& made = all.emplace_back();
        for (TopExp_Explorer at(solid.Current(), TopAbs_FACE); at.More(); at.Next()) {
            TopLoc_Location place;
            const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(at.Current()), place);
            for (int i = 1; i <= mesh->NbTriangles(); ++i) {
                Corners corners;
                for (int k = 0; k < 3; ++k) {
                    const gp_Pnt p = mesh->Node(mesh->Triangle(i).Value(k + 1)).Transformed(place.Transformation());
                    corners[static_cast<std::size_t>(k)] = {p.X(), p.Y(), p.Z()};
                    made.box.extend(corners[static_cast<std::size_t>(k)]);
                }
                made.triangles.push_back(corners);
            }
        }
    }
    return all;
}

/// How far solids reach along a direction, at the pixels of a window across it.
class Depths {
public:
    static constexpr double kPixel_mm = 0.2, kTouch_mm = 0.05;
    /// @param axes rows: two across, and the direction @param farthest else the nearest surface is kept
    Depths(const Eigen::Matrix3d& axes, const Eigen::AlignedBox2d& window, bool farthest)
        : axes_(axes), low_(window.min()), sign_(farthest ? 1.0 : -1.0) {
        const Eigen::Vector2d size = window.sizes() / kPixel_mm;
        wide_ = static_cast<int>(size.x()) + 2, high_ = static_cast<int>(size.y()) + 2;
        depth_.assign(static_cast<std::size_t>(wide_ * high_), -INFINITY);
    }
    void add(const Solid& solid) {
        for (const Corners& t : solid.triangles) add({axes_ * t[0], axes_ * t[1], axes_ * t[2]});
    }
    /// Is a square of four pixels of solids that reach this far (the farthest) behind the nearest of what is there?
    [[nodiscard]] bool meets(const Depths& there) const {
        const auto behind = [&](int x, int y) { return depth(x, y) > there.depth(x, y) + kTouch_mm; };
        for (int y = 0; y + 1 < high_; ++y)
            for (int x = 0; x + 1 < wide_; ++x)
                if (behind(x, y) && behind(x + 1, y) && behind(x, y + 1) && behind(x + 1, y + 1)) return true;
        return false;
    }

private:
    [[nodiscard]] double depth(int x, int y) const { return sign_ * depth_[static_cast<std::size_t>(y * wide_ + x)]; }
    void add(const Corners& t) {
        const auto pixel = [&](const Eigen::Vector3d& p) { return Eigen::Vector2d((p.head<2>() - low_) / kPixel_mm); };
        const Eigen::Vector2d a = pixel(t[0]), b = pixel(t[1]), c = pixel(t[2]), ab = b - a, ac = c - a;
        const double area = ab.x() * ac.y() - ab.y() * ac.x();
        if (std::abs(area) < 1e-9) return;  // seen from its edge
        const Eigen::Vector2d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
        for (int y = std::max(0, static_cast<int>(std::ceil(low.y()))); y <= std::min(high_ - 1.0, high.y()); ++y)
            for (int x = std::max(0, static_cast<int>(std::ceil(low.x()))); x <= std::min(wide_ - 1.0, high.x()); ++x) {
                const Eigen::Vector2d p = Eigen::Vector2d(x, y) - a;
                const double u = (p.x() * ac.y() - p.y() * ac.x()) / area, v = (ab.x() * p.y() - ab.y() * p.x()) / area;
                if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
                double& here = depth_[static_cast<std::size_t>(y * wide_ + x)];
                here = std::max(here, sign_ * (t[0].z() + u * (t[1].z() - t[0].z()) + v * (t[2].z() - t[0].z())));
            }
    }

    Eigen::Matrix3d axes_;
    Eigen::Vector2d low_;
    double sign_;
    int wide_ = 0, high_ = 0;
    std::vector<double> depth_;
};

/// Does a solid that comes along a direction from afar meet another one before it is in its place?
inline bool is_blocked(const Solid& moving, const Solid& there, const Eigen::Vector3d& along) {
    Eigen::Matrix3d axes;
    const Eigen::Vector3d x = std::abs(along.x()) > 0.5 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
    axes << x.transpose(), along.cross(x).transpose(), along.transpose();
    const auto seen = [&](const Solid& solid) {
        Eigen::AlignedBox3d box;
        for (int i = 0; i < 8; ++i) box.extend(axes * solid.box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
        return box;
    };
    const Eigen::AlignedBox3d one = seen(moving), other = seen(there);
    const Eigen::Vector2d low = one.min().cwiseMax(other.min()).head<2>(), high = one.max().cwiseMin(other.max()).head<2>();
    if ((high - low).minCoeff() <= 0.0 || other.min().z() > one.max().z() - Depths::kTouch_mm) return false;
    const Eigen::AlignedBox2d window(low, high);
    Depths front(axes, window, true), back(axes, window, false);
    front.add(moving), back.add(there);
    return front.meets(back);
}

}  // namespace fusee::step_geometry
