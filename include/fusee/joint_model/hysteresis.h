#pragma once
#include "fusee/joint_model/rig_lanes.h"

namespace fusee::joint_model {

/// F (1 + a z): z goes from -1 (unloading) to 1 (loading) within kTurnover of deflection.
template <class V>
struct HysteresisOf {
    V torque(V x, V elastic, V a) {
        z = clamped(z + 2.0 * (x - last) / kTurnover, V{} - 1.0, V{} + 1.0);
        last = x;
        return a == 0.0 ? elastic : elastic * (1.0 + a * z);
    }
    static constexpr double kTurnover = 0.05;  ///< [rad]
    V last{}, z = V{} - 1.0;                   ///< deflection of the last call [rad]; state
};
using Hysteresis = HysteresisOf<double>;

}  // namespace fusee::joint_model
