#pragma once
#include <BRepAdaptor_Surface.hxx>
#include <Eigen/Geometry>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

/// The round holes and pins of a body as a STEP file has them, by OpenCASCADE alone: shares nothing with module assembly.
namespace fusee::step_geometry {

using Eigen::Vector3d;

/// A cylinder face: the wall of a hole, or of a pin. [mm]
struct Cylinder {
    Vector3d end = Vector3d::Zero(), axis = Vector3d::UnitZ();  ///< its end of least height, and the unit vector from there
    double length = 0.0, radius = 0.0;
    bool hole = false;  ///< the material is outside
    [[nodiscard]] Vector3d other_end() const { return end + length * axis; }
};

inline std::vector<Cylinder> cylinders(const TopoDS_Shape& shape) {
    std::vector<Cylinder> all;
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
        const TopoDS_Face& face = TopoDS::Face(at.Current());
        const BRepAdaptor_Surface surface(face);
        if (surface.GetType() != GeomAbs_Cylinder) continue;
        const gp_Cylinder cylinder = surface.Cylinder();
        const gp_Pnt origin = cylinder.Location();
        const gp_Dir along = cylinder.Axis().Direction();
        const Vector3d axis(along.X(), along.Y(), along.Z());
        const double from = surface.FirstVParameter(), to = surface.LastVParameter();
        const bool inward = (face.Orientation() == TopAbs_REVERSED) == bool(cylinder.Direct());
        all.push_back({Vector3d(origin.X(), origin.Y(), origin.Z()) + from * axis, axis, to - from, cylinder.Radius(), inward});
    }
    return all;
}

inline bool same(double a, double b) { return std::abs(a - b) < 1e-5; }

/// Distance of a point from the line of a cylinder.
inline double aside(const Cylinder& c, const Vector3d& point) { return (point - c.end).cross(c.axis).norm(); }
inline bool coaxial(const Cylinder& a, const Cylinder& b) { return same(aside(a, b.end), 0.0) && same(aside(a, b.other_end()), 0.0); }

/// Holes or pins of one radius, each once: a cylinder may be cut into faces around or along it.
inline std::vector<Cylinder> of_radius(const std::vector<Cylinder>& all, double radius, bool hole) {
    std::vector<Cylinder> found;
    for (const Cylinder& c : all) {
        if (c.hole != hole || !same(c.radius, radius)) continue;
        bool joined = false;
        for (Cylinder& f : found) {
            if (joined || !coaxial(f, c)) continue;
            const double a = f.axis.dot(c.end - f.end), b = f.axis.dot(c.other_end() - f.end);
            const double low = std::min({0.0, a, b}), high = std::max({f.length, a, b});
            if (high - low > f.length + c.length + 1e-5) continue;  // apart: another hole on the same line
            f.end += low * f.axis, f.length = high - low, joined = true;
        }
        if (!joined) found.push_back(c);
    }
    return found;
}

/// Length of `hole` that lies between the ends of `pin`, on one line.
inline double covered(const Cylinder& hole, const Cylinder& pin) {
    const double a = hole.axis.dot(pin.end - hole.end), b = hole.axis.dot(pin.other_end() - hole.end);
    return std::min(std::max(a, b), hole.length) - std::max(std::min(a, b), 0.0);
}

}  // namespace fusee::step_geometry
