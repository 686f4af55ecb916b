#pragma once
#include <Eigen/Geometry>

class gp_Trsf;

namespace fusee::exchange::brep {

/// A proper rotation and a translation [mm] for OpenCASCADE.
[[nodiscard]] gp_Trsf transform_of(const Eigen::Isometry3d& placement);

}  // namespace fusee::exchange::brep
