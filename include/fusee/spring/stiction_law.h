#pragma once
#include "fusee/core/finding.h"
#include "fusee/spring/law.h"

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

/// The paper's (19) at the capstan angle theta of the law (0 at its start): has the cubic between angle and load one real root? Reported,
/// not a filter: with three roots the law is as valid, and one of them is its load.
/// @pre theta below the law's asymptote
[[nodiscard]] bool single_real_root(const StictionLawOptions& options, double theta);

}  // namespace fusee::spring
