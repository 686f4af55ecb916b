#pragma once
#include <optional>

#include "fusee/cam/arm.h"
#include "fusee/cam/cam.h"
#include "fusee/core/units.h"
#include "fusee/spring/law.h"

namespace fusee::search::codesign {

/// Figures of a contour's working arc, even if it cannot be cut: measured on contacts alone, to guide a search.
struct Shape {
    double least_rho = 0.0;  ///< radius of curvature [m]; NaN where the cable has no tangent
    double least_arm = 0.0;  ///< [m]
    double radius = 0.0;     ///< largest distance of the centreline from the axis [m]
    double wrap = 0.0;       ///< of normals [rad]
};
[[nodiscard]] Shape shape_of(const cam::ArmFunction& arm, const cam::CamOptions& options);

/// Largest distance of a finished contour's centreline from the axis, idle arc and run-outs included [m].
[[nodiscard]] double contour_radius(const cam::Cam& cam);

/// Capstan angles at one edge of the dead-band of two equal sides: capstan 1 carries the low load, capstan 2 the high one
/// (docs/theory/dead_band.md, eq. 5-7). Beyond its ends the law continues with its stiffness there, so that a law that is too short
/// shows by how much: `low` may be below 0 and `high` above the law's last angle.
struct Edges {
    double low = 0.0, high = 0.0;  ///< [rad]
    /// Full width at the joint [rad], both edges.
    [[nodiscard]] double width(double ratio) const { return (high - low) / ratio; }
};

/// Newton's steps on the two balances at once; none if they do not converge. Inside the law, equal to
/// `actuator::dead_band`, which nests two bracketed roots, at a tenth of its cost.
[[nodiscard]] std::optional<Edges> find_edges(const spring::SpringLaw& law, core::Range loads);

}  // namespace fusee::search::codesign
