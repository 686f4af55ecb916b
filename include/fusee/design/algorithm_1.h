#pragma once
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "fusee/core/units.h"

namespace fusee::design {

/// The settings of the paper's Algorithm 1.
struct Algorithm1Options {
    core::Range k{0.05, 2.0};                        ///< box of k [1/(Nm rad)], low > 0
    core::Range u{0.0, 0.3};                         ///< box of u [Nm]; only u^2 enters, so that a box around 0 has every design twice
    core::Range c{0.0, 0.5};                         ///< box of C [Nm]
    int torques = 20;                                ///< levels of co-contraction, both ends included, >= 2
    double wanted_travel = 0.0;                      ///< wanted capstan angle from least to peak torque [rad], > 0
    double joint_range = core::rad_from_deg(120.0);  ///< greatest dead-band: the joint cannot turn farther [rad]
    double weight_travel = 5.0;                      ///< W1 of |travel - wanted| [1/rad], >= 0
    double weight_dead_band = 1.0;                   ///< W2 of (final - initial dead-band) [1/rad], >= 0: rewards a falling dead-band
    double weight_sensitivity = 0.1;                 ///< W3 of the joint's final sensitivity [Nm/rad], >= 0
};

/// The actuator that the springs are for.
struct Algorithm1Rig {
    double mu = 0.0;            ///< gear friction proportional to the load, > 0
    double ratio = 1.0;         ///< g = r_j/r_c
    core::Range torques;        ///< least and peak co-contraction [Nm]
    double highest_load = 0.0;  ///< of the springs [Nm], at least torques.high: stiction loads a capstan beyond the motor's torque
};

/// The figures of one (k, u, C) in Algorithm 1.
struct Algorithm1Terms {
    bool feasible = false;             ///< both stiffnesses above 0 at every load: the second stage applies
    double least_stiffness = 0.0;      ///< min of U3'', U4'' over the levels and the highest load [Nm/rad]; -infinity where T = 0
    double travel = kNone;             ///< capstan angle from least to peak torque [rad]; this and what follows NaN if not feasible
    double initial_dead_band = kNone;  ///< linear, full width at the joint, at the least torque [rad], at most the joint's range
    double final_dead_band = kNone;    ///< the same at the peak torque
    double sensitivity = kNone;        ///< dq/dtau_q at the peak torque, capstans free [rad/Nm]
    double cost = 0.0;
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
};

/// The cost of Algorithm 1 in closed form (docs/theory/algorithm_1.md). Immutable and reentrant.
///     stage 1, if a stiffness is not above 0:  |min(U3'', U4'')|
///     stage 2:  W1 |travel - wanted| + W2 (final - initial dead-band) + W3 sensitivity
class Algorithm1 {
public:
    /// @throws InvalidInput naming the option
    Algorithm1(const Algorithm1Options& options, const Algorithm1Rig& rig);

    /// @param x (k, u, C); u and -u cost the same
    [[nodiscard]] double operator()(std::span<const double> x) const;
    [[nodiscard]] Algorithm1Terms terms(std::span<const double> x) const;

    /// The second stage's sum.
    [[nodiscard]] double weighed(double travel, double initial_dead_band, double final_dead_band, double sensitivity) const;

    /// The boxes of k, u and C, in the order of x.
    [[nodiscard]] std::vector<core::Range> bounds() const { return {options_.k, options_.u, options_.c}; }
    [[nodiscard]] const Algorithm1Options& options() const { return options_; }
    [[nodiscard]] const Algorithm1Rig& rig() const { return rig_; }
    /// The levels of co-contraction and, where it lies above them, the highest load [Nm].
    [[nodiscard]] const std::vector<double>& loads() const { return loads_; }

private:
    [[nodiscard]] bool feasible(double k, double a, double c) const;
    [[nodiscard]] double least_stiffness(double k, double a, double c) const;
    [[nodiscard]] Algorithm1Terms second_stage(double k, double a, double c) const;

    Algorithm1Options options_;
    Algorithm1Rig rig_;
    std::vector<double> loads_;
    double i3_ = 0.0, i4_ = 0.0;  ///< integrals of tau^-3 and tau^-4 over the torques
};

/// One plot of the paper's figure 9: the cost over one variable, the other two at the optimum.
struct CostScan {
    const char* variable = "";  ///< "k", "u" or "C"
    std::vector<double> value, cost;
    std::vector<bool> feasible;
};
/// Scans over k, u and C; the one over u has both signs. @throws InvalidInput if count < 2
[[nodiscard]] std::array<CostScan, 3> scan_costs(const Algorithm1& algorithm, std::span<const double> optimum, int count);

}  // namespace fusee::design
