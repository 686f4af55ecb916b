#pragma once
#include <memory>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/units.h"

/// Laws of a pair of springs at one capstan.
namespace fusee::spring {

/// The pair of springs at one capstan, at one level of equal co-contraction (joint at rest, so both springs have the capstan's angle).
/// Magnitudes: every torque is positive and rises with theta. theta is 0 at the lowest load of the law.
struct LawPoint {
    double tau = 0.0;      ///< capstan load F_SE + F_PE [Nm]
    double theta = 0.0;    ///< capstan angle [rad]
    double f_se = 0.0;     ///< series torque U_3' at the capstan [Nm]
    double f_pe = 0.0;     ///< parallel torque U_4' at the capstan [Nm]
    double s = 0.0;        ///< S = dF_SE/dtheta [Nm/rad]
    double p = 0.0;        ///< P = dF_PE/dtheta [Nm/rad]
    double s_slope = 0.0;  ///< dS/dtheta [Nm/rad^2]
    double p_slope = 0.0;  ///< dP/dtheta [Nm/rad^2]
    double u_se = 0.0;     ///< energy of K_SE above its state at theta = 0 [J]
    double u_pe = 0.0;     ///< energy of K_PE above its state at theta = 0 [J]
    /// T = S/(S+P), paper (8): the share of a stiction torque that reaches the joint's cable.
    [[nodiscard]] double transmission() const { return s / (s + p); }
};

/// A pair of spring laws, immutable and reentrant. Load and angle identify the same point: both rise together.
class SpringLaw {
public:
    virtual ~SpringLaw() = default;
    /// Loads that the law covers [Nm], lead-in included.
    [[nodiscard]] virtual core::Range loads() const = 0;
    /// Capstan angles that the law covers [rad]; low is 0.
    [[nodiscard]] virtual core::Range angles() const = 0;
    /// @pre tau in loads() (clamped to it)
    [[nodiscard]] virtual LawPoint at_load(double tau) const = 0;
    /// @pre theta in angles() (clamped to it)
    [[nodiscard]] virtual LawPoint at_angle(double theta) const = 0;
};
using SpringLawPtr = std::shared_ptr<const SpringLaw>;

/// `count` points, evenly spaced in load, both ends included. @throws InvalidInput if count < 2
[[nodiscard]] std::vector<LawPoint> sample_by_load(const SpringLaw& law, std::size_t count);

/// Is the law a pair of springs: S > 0, P > 0 (so 0 < T < 1) and F_SE > 0, F_PE > 0 over the whole range?
/// Broken: findings "law.transmission", "law.stiffness", "law.torque" (errors) with the load where it first fails.
[[nodiscard]] core::Findings check_law(const SpringLaw& law);

/// Extends a law below its start: over `travel` [rad] of capstan both stiffnesses continue with their slope at the start, which falls
/// linearly to zero at the lower end: S(x) = S0 + S0' (x + x^2/(2 travel)), x in [-travel, 0]. U''' is continuous, so the arms are
/// C2. Below it the springs rest on their preload stops. travel = 0 returns the law. Refusal: "law.lead_in" if a stiffness or torque would
/// not stay above zero, with the largest travel for which both do.
/// @throws InvalidInput if travel is negative or not finite
[[nodiscard]] core::Outcome<SpringLawPtr> with_lead_in(SpringLawPtr law, double travel);

}  // namespace fusee::spring
