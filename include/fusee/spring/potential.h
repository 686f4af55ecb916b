#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/units.h"
#include "fusee/spring/base_spring.h"
#include "fusee/spring/law.h"

/// One spring over its deflection, and the springs that follow from it.
namespace fusee::spring {

/// One nonlinear spring at the capstan: force = dU/dx [Nm] over deflection x [rad], C3 in U.
class Potential {
public:
    virtual ~Potential() = default;
    [[nodiscard]] virtual core::Range domain() const = 0;
    [[nodiscard]] virtual double energy(double x) const = 0;     ///< U(x) [J]
    [[nodiscard]] virtual double force(double x) const = 0;      ///< U'(x) [Nm]
    [[nodiscard]] virtual double stiffness(double x) const = 0;  ///< U''(x) [Nm/rad]
    [[nodiscard]] virtual double slope(double x) const = 0;      ///< U'''(x) [Nm/rad^2]
};
using PotentialPtr = std::shared_ptr<const Potential>;

/// Upper end of a formula's domain [rad]: 16 turns, more than any capstan winds. The lower end is 0, the preload stop.
inline constexpr double kLongestDeflection = 100.0;

/// F(x) = sum_i coefficients[i] x^i, coefficients[0] = torque at x = 0. @throws InvalidInput
[[nodiscard]] PotentialPtr make_polynomial(std::vector<double> coefficients);
/// F(x) = scale (exp(rate x) - 1) + offset. @throws InvalidInput
[[nodiscard]] PotentialPtr make_exponential(double scale, double rate, double offset);

/// A measured curve.
struct TableOptions {
    int knots = 16;           ///< intervals of the quintic B-spline
    double smoothing = -1.0;  ///< weight of the roughness penalty; below 0: chosen by generalised cross-validation
};
/// Quintic smoothing spline (C4) through noisy (x, F) rows: penalised B-spline (Eilers & Marx 1996). Domain: the rows' range.
/// @pre x ascending, at least 8 rows, all finite. @throws InvalidInput naming the row
[[nodiscard]] PotentialPtr make_tabulated(const std::vector<double>& x, const std::vector<double>& force, const TableOptions& options = {});

/// Two potentials over the same capstan angle, as a law whose range is given by loads [Nm].
/// Refusal: "law.range" if a load is not reached inside the potentials' domains, "law.stiffness" if the load does not rise with the angle.
[[nodiscard]] core::Outcome<SpringLawPtr> make_pair_law(PotentialPtr series, PotentialPtr parallel, double start_torque, double end_torque);

/// A spring from its torque alone, a function of the angle [rad] with two continuous derivatives: its piecewise Chebyshev interpolant, of
/// the accuracies of `resampled`, with bounds. Energy counts from the domain's low end.
/// @throws InvalidInput naming `key` and the angle of a step or kink, or of a value that is not finite
[[nodiscard]] PotentialPtr make_of_torque(const std::string& key, const std::function<double(double)>& torque, core::Range domain);

/// One spring alone as a law: the torques and stiffnesses of both sides are its own, and its points are named by the angle from the first
/// one, 0 to the domain's width [rad], in place of the load: a torque that is constant, falls or changes its sign names no place.
[[nodiscard]] SpringLawPtr make_one_spring_law(PotentialPtr spring);

/// The same spring tabulated once, for many evaluations: its force as piecewise Chebyshev series with their exact integral and
/// derivatives. Relative accuracy of the force 1e-12, of stiffness and slope 1e-9 and 1e-6; near an asymptote, where the load is
/// ill-conditioned in the angle, up to 1000 times less. A spring with kinks, for which no series converges, is returned unchanged.
[[nodiscard]] PotentialPtr resampled(PotentialPtr spring);

/// The same spring, extended beyond both ends by a share of its range, along the chord of its last piece of that length; below its lower
/// end no farther than to a torque of 0.
[[nodiscard]] PotentialPtr continued(PotentialPtr spring, double share);

/// A spring with a linear compliance c [rad/Nm] in series, as behind a cable that stretches:
///     X = x + c (F(x) - F_low),   dF/dX = S/(1 + c S),   d2F/dX2 = S'/(1 + c S)^3                    (docs/theory/springs.md, eq. 28)
/// The deflection counts from the spring's lower end, where the cable is already taut and carries F_low. c = 0 returns the spring.
/// c below 0 removes a compliance that the spring already contains. @throws InvalidInput unless 1 + c S > 0 at both ends of the domain
[[nodiscard]] PotentialPtr with_compliance(PotentialPtr spring, double compliance);

/// The two springs of a law, each over the capstan's angle; their domain is the law's angles. They share the law.
[[nodiscard]] PotentialPtr series_spring(SpringLawPtr law);
[[nodiscard]] PotentialPtr parallel_spring(SpringLawPtr law);

/// A spring behind a cable, defined at every deflection: inside `domain()` the spring itself; below it the preload stop, where the force
/// falls linearly to 0 within `stop_travel` and stays 0 (a cable cannot push); above it the force continues with the stiffness at the law's
/// end. C1 energy, convex if the spring is. `domain()` stays that of the spring, so that a caller can see which applies.
/// @throws InvalidInput unless stop_travel > 0, and if the spring would push at its lower end
[[nodiscard]] PotentialPtr behind_cable(PotentialPtr spring, double stop_travel = 1e-4);

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
/// A `resampled` nominal spring makes it fast.
/// @param nominal over the capstan's angle; its energy is counted from the preloaded state at the domain's lower end
/// @throws InvalidInput if an arm would not stay above 0, or a rate or preload not above 0
[[nodiscard]] PotentialPtr make_built_spring(PotentialPtr nominal, const BaseSpring& base, double capstan_radius, const BuildError& error);

}  // namespace fusee::spring
