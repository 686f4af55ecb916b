#pragma once
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/math/curve.h"
#include "fusee/spring/friction.h"
#include "fusee/spring/law.h"

/// How laws are made: closed in the load, from curves, from a wanted dead-band.
///
/// Example:
/// @code
/// const auto law = spring::make_stiction_law(
///     {.k = 0.225, .u = 0.0012, .c = 0.265, .mu = 0.28, .start_torque = 0.6, .end_torque = 2.21});
/// if (!law) return law.refusal();  // findings: limit, measured, nearest change
/// const auto whole = spring::with_lead_in(*law, core::rad_from_deg(3.0));  // below its start, so that arms are C2
/// for (const spring::LawPoint& at : spring::sample_by_load(**whole, 200))
///     std::cout << at.tau << ' ' << at.theta << ' ' << at.f_se << ' ' << at.f_pe << '\n';
/// @endcode
namespace fusee::spring {

/// The paper's stiction-compensating springs (k, u, C): S = k tau^2 (16), T = u^2/(mu tau^2) + C/tau (11), P = (1/T - 1) S (12).
struct StictionLawOptions {
    double k = 0.0;             ///< [1/(Nm rad)]
    double u = 0.0;             ///< dead-band reduction rate [Nm]; only u^2 enters
    double c = 0.0;             ///< constant of integration C [Nm]
    double mu = 0.28;           ///< gear friction proportional to load
    double start_torque = 0.0;  ///< lowest load of the law [Nm]
    double end_torque = 0.0;    ///< highest load [Nm]
};

/// Closed in tau (docs/theory/springs.md): theta, torques, stiffnesses and energies are elementary; F_SE(start) = T(start) start.
/// Refusal: "law.transmission" if T leaves (0, 1), with the least feasible start torque tau_min = (C + sqrt(C^2 + 4 u^2/mu))/2
/// (and for C < 0 the highest feasible end torque u^2/(mu |C|)).
/// @throws InvalidInput naming the option (k > 0, mu > 0, 0 < start < end, u and c finite and not both 0)
[[nodiscard]] core::Outcome<SpringLawPtr> make_stiction_law(const StictionLawOptions& options);

/// tau_min = (C + sqrt(C^2 + 4 u^2/mu))/2 [Nm]: T = 1 there, and below it the law does not exist.
[[nodiscard]] double least_feasible_load(const StictionLawOptions& options);

/// A pair of springs given over the load itself: series stiffness S(tau) and transmission T(tau). Then, by quadrature,
///     P = (1/T - 1) S,   theta = integral T/S dtau,   F_SE = F_0 + integral T dtau,   F_PE = tau - F_SE,   F_0 = T(start) start.
/// Relative accuracy of the quadrature 1e-12 (docs/theory/springs.md, eq. 16 to 18). Only values and first derivatives of the curves are
/// used; where these are continuous, the springs' energies are C3. Refusals: "law.transmission" if T leaves (0, 1), "law.stiffness" if S
/// is not above 0.
/// @throws InvalidInput if 0 < start < end does not hold or the curves do not reach over it
[[nodiscard]] core::Outcome<SpringLawPtr> make_transmission_law(math::CurvePtr series_stiffness, math::CurvePtr transmission,
                                                                double start_torque, double end_torque);

/// Springs from a wanted dead-band: P = 2 tau_f(tau)/(g DB(tau)), T = S/(S + P).
struct DeadBandLawOptions {
    math::CurvePtr dead_band;              ///< DB(tau), linear full width at the joint [rad], > 0
    math::CurvePtr series_stiffness = {};  ///< S(tau) [Nm/rad]; empty: chosen, S = k tau^2 (paper (16)) with `start_transmission`
    double start_transmission = 0.5;       ///< T at the start torque, when S is chosen
    FrictionLaw friction = FrictionLaw::proportional(0.28);
    double ratio = 1.0;         ///< g = r_j/r_c
    double start_torque = 0.0;  ///< [Nm]
    double end_torque = 0.0;    ///< [Nm]
};
/// The linear dead-band of these springs, 2 tau_f/(g P), is the wanted one to rounding (docs/theory/springs.md, eq. 19 and 20).
/// Refusals: "law.dead_band" if DB is narrower than that of a parallel stiffness of 1000 times S (a vanishing dead-band needs an infinitely
/// stiff K_PE), with that least DB and the nearest torques; and those of make_transmission_law.
/// @throws InvalidInput if a curve does not reach over the torques, the friction is 0 at one of them, or an option is out of its range
[[nodiscard]] core::Outcome<SpringLawPtr> make_dead_band_law(const DeadBandLawOptions& options);

/// The paper's law (7)-(9) for any friction: T tau_f = mu C + u^2/tau, so T = (mu C + u^2/tau)/tau_f(tau), S = k tau^2; mu is the
/// friction's mu(), tau_f at 1 Nm. With proportional friction the same springs as make_stiction_law (which is closed in tau and faster).
struct GeneralStictionOptions {
    double k = 0.0, u = 0.0, c = 0.0;  ///< as StictionLawOptions; c multiplies friction.mu()
    FrictionLaw friction = FrictionLaw::proportional(0.28);
    double start_torque = 0.0, end_torque = 0.0;  ///< [Nm]
};
/// Refusals: those of make_transmission_law. @throws InvalidInput as make_stiction_law, and if the friction is 0
[[nodiscard]] core::Outcome<SpringLawPtr> make_general_stiction_law(const GeneralStictionOptions& options);

/// A free pair of curves: S and T through knots over the load, ln S and ln(T/(1-T)) interpolated (C4, `math::make_interpolant`), so that
/// every choice of knots is a pair of springs. Co-design searches it unless it is limited to (k, u, C). Refused only if values overflow,
/// which takes extremely different neighbours.
struct FreeCurveOptions {
    std::vector<double> loads;             ///< ascending, at least 4 [Nm]; first and last are the law's ends
    std::vector<double> series_stiffness;  ///< S at the knots [Nm/rad], > 0
    std::vector<double> transmission;      ///< T at the knots, in (0, 1)
};
/// @throws InvalidInput naming the knot
[[nodiscard]] core::Outcome<SpringLawPtr> make_free_curve(const FreeCurveOptions& options);

}  // namespace fusee::spring
