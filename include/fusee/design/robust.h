#pragma once
#include <array>

#include "fusee/actuator/joint.h"
#include "fusee/spring/base_spring.h"

namespace fusee::design {

/// Standard deviations of built actuators from the drawing. Each of the four springs and of the two gears has an independent error. The
/// defaults take a shop's "+-10 %" (springs) and "+-20 %" (friction) as two deviations.
struct ShopScatter {
    double rate_se = 0.05;     ///< of a K_SE base spring's rate, relative
    double rate_pe = 0.05;     ///< of a K_PE base spring's rate, relative
    double contour = 0.05e-3;  ///< of the excess of a cam's arms [m]: one value along the whole cam
    double friction = 0.10;    ///< of a gear's friction, relative
};

/// A joint as drawn: the actuator and the base springs of its cams (their preloads at the law's lowest load, lead-in included).
struct DrawnJoint {
    actuator::Actuator actuator;
    spring::BaseSpring base_se, base_pe;
};

/// The exact dead-band (`DeadBand::exact_width`, full width at the joint) of built actuators, by first-order propagation.
struct RobustBand {
    double tau = 0.0;                 ///< co-contraction [Nm]
    double nominal = 0.0;             ///< as drawn [rad]; NaN, like all that follows, if the drawing's springs do not cover it
    double sigma = 0.0;               ///< standard deviation [rad]
    core::Range band;                 ///< 5th and 95th percentile [rad]
    std::array<double, 4> sources{};  ///< the sigma that each member of ShopScatter alone would give, in their order [rad]
    double covered_share = 0.0;       ///< estimated share of built actuators whose springs reach both edges; 0 if the drawing's do not
};
/// The edge is differentiated at the drawing (implicit function theorem, docs/theory/robust.md): one equilibrium, no finite differences,
/// smooth enough for an optimiser's objective. The band ignores built springs that end before the edge: see `covered_share`.
/// @throws InvalidInput naming the member
[[nodiscard]] RobustBand robust_dead_band(const DrawnJoint& drawn, double tau, const ShopScatter& scatter = {});

}  // namespace fusee::design
