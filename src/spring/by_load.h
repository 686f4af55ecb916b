#pragma once
#include <functional>
#include <vector>

#include "fusee/math/curve.h"
#include "fusee/spring/friction.h"
#include "fusee/spring/law.h"

// Laws given over the load itself (docs/theory/springs.md, eq. 16 to 18): each of them defines the stiffnesses at a load.
namespace fusee::spring {

/// Both stiffnesses at one load and their slopes by the load; of numbers, or of boxes.
template <class T>
struct BasicStiffnesses {
    T s = 0.0, p = 0.0;            ///< S, P [Nm/rad]
    T s_rate = 0.0, p_rate = 0.0;  ///< dS/dtau, dP/dtau [1/rad]
};
using Stiffnesses = BasicStiffnesses<double>;

/// One formula, evaluated at loads and over boxes of loads.
class StiffnessesAt {
public:
    /// @param formula takes a double or a math::Jet and returns its BasicStiffnesses; curves in it by `math::derivative`
    /// @param breaks  loads between which it is smooth: `math::breaks` of its curves, rows of its friction
    template <class Formula>
    StiffnessesAt(const Formula& formula, std::vector<double> breaks) : at_(formula), over_(formula), breaks_(std::move(breaks)) {}

    [[nodiscard]] Stiffnesses operator()(double tau) const { return at_(tau); }
    [[nodiscard]] BasicStiffnesses<math::Jet> operator()(const math::Jet& tau) const { return over_(tau); }
    [[nodiscard]] const std::vector<double>& breaks() const { return breaks_; }

private:
    std::function<Stiffnesses(double)> at_;
    std::function<BasicStiffnesses<math::Jet>(const math::Jet&)> over_;
    std::vector<double> breaks_;
};

/// @throws InvalidInput naming `field` unless the curve covers all loads
void require_reach(const char* field, const math::Curve& curve, core::Range loads);
/// @throws InvalidInput unless there is stiction at both ends of the loads
void require_friction(const FrictionLaw& friction, core::Range loads);

/// P and its slope from S, dS/dtau, T and dT/dtau: P = (1/T - 1) S.
template <class T>
[[nodiscard]] BasicStiffnesses<T> from_transmission(const T& s, const T& s_rate, const T& t, const T& t_rate) {
    const T ratio = 1.0 / t - 1.0;  // P/S
    return {s, ratio * s, s_rate, ratio * s_rate - s * t_rate / (t * t)};
}

/// The law by quadrature on Chebyshev pieces, relative accuracy 1e-12; refused as `check_stiffnesses` does.
/// @param edges ascending loads: the law's ends, and between them the known places where the stiffnesses are less smooth
/// @param looked_over the stiffnesses are positive by construction: the scan of the range is skipped (the points of the quadrature are
/// still checked)
[[nodiscard]] core::Outcome<SpringLawPtr> integrate_by_load(StiffnessesAt stiffnesses, const std::vector<double>& edges,
                                                            bool looked_over = false);

}  // namespace fusee::spring
