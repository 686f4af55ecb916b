#pragma once
#include <vector>

#include "fusee/core/units.h"

namespace fusee::math {
struct Jet;
}

namespace fusee::spring {

/// Friction of a gear over the load on its capstan, tau_f(load): paper, footnote 3. A capstan at motor torque tau rests while
/// |tau - load| <= at_rest(load), and slides with |tau - load| = in_motion(load). Immutable value; loads and torques at the capstan [Nm];
/// of a signed load the magnitude counts.
class FrictionLaw {
public:
    /// tau_f = mu |load|: the paper's figure 8. @throws InvalidInput unless 0 <= mu <= 0.95
    [[nodiscard]] static FrictionLaw proportional(double mu);
    /// tau_f = constant + mu |load| in motion, (1 + rest_excess) times that at rest (Stribeck's curve at speed 0).
    /// @throws InvalidInput unless constant >= 0, rest_excess >= 0, (1 + rest_excess) mu in [0, 0.95]
    [[nodiscard]] static FrictionLaw affine(double constant, double mu, double rest_excess = 0.0);
    /// Measured: monotone cubic (PCHIP) through the rows, its end slopes beyond them.
    /// @pre loads ascending from >= 0, at least 2 rows. @throws InvalidInput naming the row (also if the slope reaches 0.95:
    /// self-locking)
    [[nodiscard]] static FrictionLaw tabulated(std::vector<double> loads, std::vector<double> torques, double rest_excess = 0.0);

    [[nodiscard]] double at_rest(double load) const;    ///< [Nm], >= 0
    [[nodiscard]] double in_motion(double load) const;  ///< [Nm], >= 0
    [[nodiscard]] double slope(double load) const;      ///< right derivative of at_rest by |load|
    /// Loads at which the slope may jump: a table's rows, otherwise none.
    [[nodiscard]] const std::vector<double>& rows() const { return loads_; }
    /// at_rest and slope over a box of loads (math/interval.h). @pre loads >= 0, no row inside the box
    [[nodiscard]] math::Jet at_rest(const math::Jet& load) const;
    [[nodiscard]] math::Jet slope(const math::Jet& load) const;
    /// Loads that a resting capstan at `motor_torque` may carry: load + tau_f = motor_torque .. load - tau_f = motor_torque.
    [[nodiscard]] core::Range resting_loads(double motor_torque) const;
    /// The same with friction in motion: the load of a capstan that winds in (low) or pays out (high).
    [[nodiscard]] core::Range moving_loads(double motor_torque) const;
    /// Is tau_f exactly mu |load|, as the closed forms of the (k, u, C) law need?
    [[nodiscard]] bool is_proportional() const;
    /// at_rest(1 Nm), which is mu of a proportional law.
    [[nodiscard]] double mu() const { return at_rest(1.0); }

private:
    template <class T>
    struct LineOf {
        T value, slope;
    };
    using Line = LineOf<double>;
    FrictionLaw() = default;
    template <class T>
    [[nodiscard]] LineOf<T> interpolate(const T& size, double within) const;
    [[nodiscard]] core::Range balanced(double motor_torque, double excess) const;
    double constant_ = 0.0, mu_ = 0.0, rest_excess_ = 0.0;
    std::vector<double> loads_, torques_, slopes_;  ///< of a table
};

/// Loads that a resting capstan may carry whose gear has `factor` times this friction. NaN if it locks itself.
[[nodiscard]] core::Range resting_loads(const FrictionLaw& gear, double motor_torque, double factor);

}  // namespace fusee::spring
