#pragma once
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "fusee/exchange/dxf.h"
#include "fusee/exchange/part_file.h"

namespace fusee::readback {

using Point = std::array<double, 2>;

/// The point turned about the axis by `angle` [rad].
[[nodiscard]] inline Point turned(const Point& p, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p[0] - s * p[1], s * p[0] + c * p[1]};
}

/// One point of the groove's floor in the file, in the body frame.
struct FloorPoint {
    Point xy_mm{};
    double azimuth = 0.0;  ///< of the ray that found it [rad], unwrapped along the groove
};

struct Floor {
    std::vector<FloorPoint> points;
    bool planar = true;               ///< the whole outline lies at one height; otherwise each point belongs to one turn
    std::vector<double> row_azimuth;  ///< of the expected floor under each target row [rad], unwrapped in the same way
    std::vector<double> reach_mm;     ///< from each point to the centreline of a cable on it [mm]; empty: half a cable
};

/// Distance from the axis to the floor along a horizontal ray [mm], if it meets the floor, over azimuth [rad] and height [mm].
using Ray = std::function<std::optional<double>(double azimuth, double z_mm)>;

/// Uses rays along the working arc, about five per target row, and around the whole outline if the contacts have one height. Each ray is
/// at a contact's height. A ray without a hit leaves a gap.
[[nodiscard]] Floor find_floor(const Ray& ray, const exchange::PartFile& part);
/// The same in a mesh: the outermost hit is the floor, which is open to the outside.
[[nodiscard]] Floor find_floor(const solid::Mesh& mesh, const exchange::PartFile& part);

/// The curve of a drawing that gives the floor.
enum class Drawn {
    kPolyline,  ///< the vertices of the layer FLOOR
    kSpline,    ///< points of the splines of the layer FLOOR_SPLINE
};
/// The floor as drawn. @throws IoError if the drawing has no such curve or the part is not planar
[[nodiscard]] Floor drawn_floor(const exchange::DxfDrawing& drawing, Drawn drawn, const exchange::PartFile& part, const std::string& file);

}  // namespace fusee::readback
