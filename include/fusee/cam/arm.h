#pragma once
#include "fusee/spring/base_spring.h"
#include "fusee/spring/law.h"

namespace fusee::cam {

enum class PartKind {
    kSeries,    ///< K_SE: a spool that turns a torsion spring as the cable is drawn off; turns with the tension
    kParallel,  ///< K_PE: a cam on the capstan that draws in the cable of a compression spring; turns against the tension
};
[[nodiscard]] const char* to_string(PartKind kind);  ///< "k_se", "k_pe"

/// What the law asks of the cam at one load.
struct ArmPoint {
    double tau = 0.0;      ///< capstan load [Nm]: names the point
    double angle = 0.0;    ///< rotation of the cam from the law's lowest load [rad], >= 0
    double arm = 0.0;      ///< r, pivot to cable centreline [m]
    double slope = 0.0;    ///< r' = dr/dangle [m/rad]
    double bend = 0.0;     ///< r'' [m/rad^2]
    double tension = 0.0;  ///< cable tension [N]
    double state = 0.0;    ///< phi + phi0 [rad] or y + y0 [m] of the base spring
};

/// The duality of spool and cam: energy gives the arm, without an ODE (docs/theory/cams.md, table 1).
class ArmFunction {
public:
    /// @param capstan_radius r_c [m], turns the series torque into cable tension
    /// @throws InvalidInput if the base spring is of the other kind, its rate or the radius is not above 0, or its preload below 0
    ArmFunction(PartKind kind, spring::SpringLawPtr law, spring::BaseSpring base, double capstan_radius);

    [[nodiscard]] ArmPoint at_load(double tau) const;
    /// The same law on another base spring. @throws InvalidInput as the constructor
    [[nodiscard]] ArmFunction on(const spring::BaseSpring& base) const;
    [[nodiscard]] PartKind kind() const { return kind_; }
    [[nodiscard]] const spring::SpringLaw& law() const { return *law_; }
    [[nodiscard]] const spring::BaseSpring& base() const { return base_; }

private:
    PartKind kind_;
    spring::SpringLawPtr law_;
    spring::BaseSpring base_;
    double capstan_radius_;
};

}  // namespace fusee::cam
