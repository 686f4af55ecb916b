#pragma once
#include <algorithm>

namespace fusee::joint_model {

/// F (1 + a z): z goes from -1 (unloading) to 1 (loading) within kTurnover of deflection.
class Hysteresis {
public:
    double torque(double x, double elastic, double a) {
        if (a == 0.0) return elastic;
        z_ = std::clamp(z_ + 2.0 * (x - last_) / kTurnover, -1.0, 1.0);
        last_ = x;
        return elastic * (1.0 + a * z_);
    }

private:
    static constexpr double kTurnover = 0.05;  ///< [rad]
    double last_ = 0.0, z_ = -1.0;
};

}  // namespace fusee::joint_model
