#pragma once
#include "fusee/spring/base_spring.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

/// Errors of a built spring. The cam is cut for the nominal base spring and keeps its shape.
struct BuildError {
    double rate = 0.0;     ///< relative change of the base spring's rate
    double radius = 0.0;   ///< added to every arm [m]: cable thickness, over- or undercut, shrinkage
    double preload = 0.0;  ///< added to the base spring's preload [rad] or [m]
};

/// The spring that the nominal cam makes with those errors: exact, no interpolation (docs/theory/springs.md, eq. 24 to 27). With the arm r
/// of the nominal cam on its nominal base spring:
/// K_SE (spool), angle c:  x = integral (r + dr) dc / r_c,  F = r_c k (c + phi0 + dphi0)/(r + dr),  k = k_t (1 + rate)
/// K_PE (cam), angle x:    y = integral (r + dr) dx,        F = k (y + y0 + dy0)(r + dr)
/// Its energy counts from its preloaded state at the domain's lower end. Domain: the capstan angles at which the cam is within its working
/// arc; that of a K_SE grows or shrinks with the radius.
/// A `resampled` nominal spring makes it fast (resampled.h).
/// @param nominal over the capstan's angle; its energy is counted from the preloaded state at the domain's lower end
/// @throws InvalidInput if an arm would not stay above 0, or a rate or preload not above 0
[[nodiscard]] PotentialPtr make_built_spring(PotentialPtr nominal, const BaseSpring& base, double capstan_radius, const BuildError& error);

}  // namespace fusee::spring
