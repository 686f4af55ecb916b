#pragma once
#include <memory>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/units.h"
#include "fusee/spring/law.h"

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

}  // namespace fusee::spring
