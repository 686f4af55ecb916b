#pragma once
#include <vector>

#include "fusee/plant/rig.h"

namespace fusee::plant {

/// Torque over deflection on an even grid; 0 for a slack cable, straight on beyond the last row.
class TorqueTable {
public:
    TorqueTable() = default;
    /// @pre x ascends from 0 (equal neighbours allowed), as many torques
    TorqueTable(const std::vector<double>& x, const std::vector<double>& torque);
    [[nodiscard]] double at(double x) const {
        if (x <= 0.0) return 0.0;
        const double place = x * per_step_;
        const auto row = static_cast<std::size_t>(place < last_ ? place : last_);
        const double torque = torque_[row] + (place - static_cast<double>(row)) * (torque_[row + 1] - torque_[row]);
        return x < kTaut ? torque * (x / kTaut) : torque;
    }

private:
    static constexpr double kTaut = 0.004;  // [rad] over which a preloaded spring leaves its stop: the stop is not rigid
    std::vector<double> torque_;
    double per_step_ = 0.0, last_ = 0.0;
};

/// K_SE as built: spool angle phi with 1/2 k_t phi^2 = U and arm r(phi) = k_t phi r_c/F of the drawing; then cable length s = integral of
/// the arms as cut, F = k_t (phi + phi0) r_c/r and deflection s/r_c + F/(cable stiffness).
[[nodiscard]] TorqueTable build_series(const Nominal& nominal, const SideTruth& side);
/// K_PE as built: compression y with 1/2 k y^2 = U and arm r(theta) = tau/(k y) of the drawing; then y = integral of the arms as cut and
/// F = k (y + y0) r, far steeper once it binds.
[[nodiscard]] TorqueTable build_parallel(const Nominal& nominal, const SideTruth& side);

/// A built spring with hysteresis and creep. Starts at rest, unloaded.
class Spring {
public:
    Spring(TorqueTable table, const SpringTruth& truth) : table_(std::move(table)), truth_(truth) {}
    /// Torque [Nm] at a deflection `dt` after the last one.
    [[nodiscard]] double pull(double deflection, double dt);
    [[nodiscard]] const TorqueTable& table() const { return table_; }

private:
    TorqueTable table_;
    SpringTruth truth_;
    double last_ = 0.0, turned_ = 0.0, relaxed_ = 0.0;
};

inline double Spring::pull(double deflection, double dt) {
    double torque = table_.at(deflection);
    if (truth_.hysteresis != 0.0) {
        const double bend = (deflection - last_) / truth_.hysteresis_reach;
        turned_ = (turned_ + bend) / (1.0 + (bend < 0.0 ? -bend : bend));
        torque *= 1.0 + truth_.hysteresis * turned_;
    }
    last_ = deflection;
    if (truth_.creep_share != 0.0) {
        relaxed_ += (torque - relaxed_) * dt / truth_.creep_time;
        torque += truth_.creep_share * (torque - relaxed_);
        if (torque < 0.0) torque = 0.0;
    }
    return torque;
}

}  // namespace fusee::plant
