#pragma once
#include <functional>
#include <vector>

#include "fusee/friction/law.h"
#include "fusee/math/curve.h"
#include "fusee/spring/law.h"

// Laws given over the load itself (docs/theory/springs.md, eq. 16 to 18): every maker below says what the stiffnesses are at a load.
namespace fusee::spring {

/// Both stiffnesses at one load and their slopes by the load.
struct Stiffnesses {
    double s = 0.0, p = 0.0;            ///< S, P [Nm/rad]
    double s_rate = 0.0, p_rate = 0.0;  ///< dS/dtau, dP/dtau [1/rad]
};
using StiffnessesAt = std::function<Stiffnesses(double tau)>;

/// @throws InvalidInput naming `field` unless the curve is given over all loads
void require_reach(const char* field, const math::Curve& curve, core::Range loads);
/// @throws InvalidInput unless there is stiction at both ends of the loads
void require_friction(const friction::Law& friction, core::Range loads);

/// P and its slope from S, dS/dtau, T and dT/dtau: P = (1/T - 1) S.
[[nodiscard]] Stiffnesses from_transmission(double s, double s_rate, double t, double t_rate);

/// The law by quadrature on Chebyshev pieces, relative accuracy 1e-12; refused as `check_stiffnesses` does.
/// @param edges ascending loads: the law's ends, and between them the places where the stiffnesses are less smooth, as far as known
/// @param looked_over the stiffnesses are positive by construction: spares looking over the whole range (not the points of the quadrature)
[[nodiscard]] core::Outcome<SpringLawPtr> integrate_by_load(StiffnessesAt stiffnesses, const std::vector<double>& edges,
                                                            bool looked_over = false);

}  // namespace fusee::spring
