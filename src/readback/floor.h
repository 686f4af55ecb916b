#pragma once
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "fusee/exchange/dxf.h"
#include "fusee/exchange/part_file.h"

namespace fusee::readback {

using Point = std::array<double, 2>;

/// One place of the groove's floor as the file has it, in the body frame.
struct FloorPoint {
    Point xy_mm{};
    double azimuth = 0.0;  ///< of the ray that found it [rad], unwrapped along the groove
};

struct Floor {
    std::vector<FloorPoint> points;
    bool planar = true;               ///< the whole outline lies at one height; otherwise each point belongs to its own turn
    std::vector<double> row_azimuth;  ///< where the floor is expected under each target row [rad], unwrapped alike
    std::vector<double> reach_mm;     ///< from each point to the cable's centreline on it [mm]; empty: half a cable
};

/// Where a horizontal ray from the axis meets the floor, if it does: distance from the axis [mm] over azimuth [rad] and height [mm].
using Ray = std::function<std::optional<double>(double azimuth, double z_mm)>;

/// Shoots rays along the working arc, about five per target row, and round the whole outline where the contacts share one height, each at
/// a contact's height. A ray that hits nothing leaves a gap.
[[nodiscard]] Floor find_floor(const Ray& ray, const exchange::PartFile& part);
/// The same in a mesh: the outermost hit is the floor, which is open to the outside.
[[nodiscard]] Floor find_floor(const solid::Mesh& mesh, const exchange::PartFile& part);

/// Which of the floor's curves of a drawing.
enum class Drawn {
    kPolyline,  ///< the vertices of the layer FLOOR
    kSpline,    ///< points of the splines of the layer FLOOR_SPLINE
};
/// The floor as drawn. @throws IoError if the drawing has no such curve or the part is not planar
[[nodiscard]] Floor drawn_floor(const exchange::DxfDrawing& drawing, Drawn drawn, const exchange::PartFile& part, const std::string& file);

}  // namespace fusee::readback
