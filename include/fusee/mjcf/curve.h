#pragma once
#include <vector>

#include "fusee/joint_model/cam_spring.h"
#include "fusee/spring/potential.h"

namespace fusee::mjcf {

/// Torque of one spring behind its cable over its deflection at the capstan: the table that the companion programs interpolate. Linear
/// between even rows, `end_stiffness` beyond the last one; below `low` the preload stop, where the torque falls to 0 within `stop_travel`.
struct Curve {
    double low = 0.0, high = 0.0;  ///< first and last row [rad]
    std::vector<double> torque;    ///< [Nm], at least 2 rows
    double end_stiffness = 0.0;    ///< [Nm/rad]
    double stop_travel = 1e-4;     ///< [rad]
    double hysteresis = 0.0;       ///< a of F (1 + a z), docs/theory/diagnosis.md
    double table_error = 0.0;      ///< greatest difference from the spring, between two rows [Nm]

    [[nodiscard]] double at(double x) const;          ///< without hysteresis [Nm]
    [[nodiscard]] double greatest() const;            ///< torque of the last row [Nm]
    [[nodiscard]] double greatest_stiffness() const;  ///< over the rows [Nm/rad]
};

/// Rows until the error between them is below 1e-5 of the greatest torque. @throws core::InvalidInput unless stop_travel > 0
[[nodiscard]] Curve tabulate(const spring::Potential& spring, double stop_travel);
/// The spring of a built rig, which is linear between its own rows.
[[nodiscard]] Curve tabulate(const joint_model::CamSpring& spring, double hysteresis);

/// What MuJoCo itself can hold of a spring: F(x) = k d + k2 d^2 + k3 d^3, d = x - free, and no torque below `free`.
struct Cubic {
    double free = 0.0;                              ///< no torque up to this deflection [rad]
    double linear = 0.0, square = 0.0, cube = 0.0;  ///< [Nm/rad], [Nm/rad^2], [Nm/rad^3]
    double worst = 0.0, worst_at = 0.0;             ///< greatest error over the rows [Nm], and its deflection [rad]
    [[nodiscard]] double at(double x) const;
};
/// Least squares over the rows, among the cubics that do not fall at `free` and are nowhere negative over the rows.
[[nodiscard]] Cubic fit_cubic(const Curve& curve);

}  // namespace fusee::mjcf
