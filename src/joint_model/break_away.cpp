#include <algorithm>

#include "experiments.h"

namespace fusee::joint_model {

namespace {

constexpr double kLocked = 1e3;  ///< replaces a load that does not exist because friction grows faster, on the reference rig [Nm]

/// The load at which |load - torque| = c + m load + k load^2, on the side above (backdrive) or below the torque.
double break_away_load(double torque, double way, double c, double m, double k, double locked) {
    double load = (torque + way * c) / (1.0 - way * m);
    for (int i = 0; i < 20 && k != 0.0; ++i) load = std::min(locked, (torque + way * (c + k * load * load)) / (1.0 - way * m));
    return std::max(0.0, load);
}

}  // namespace

std::vector<double> predict_break_away(const BuiltRig& rig, const std::vector<gap_case::BreakAway>& rows,
                                       const gap_case::Protocol& protocol) {
    std::vector<double> loads;
    const double locked = kLocked * rig.reference.torque;
    for (const gap_case::BreakAway& row : rows) {
        const Gear& gear = rig.sides[row.side == to_string(gap_case::Side::kAgonist) ? 0 : 1].gear;
        const double way = row.backdrive ? 1.0 : -1.0;  // the load drives back: the cable pays out
        const double session = break_away_time(protocol) * static_cast<double>(loads.size());
        const double at_rest = (1.0 + gear.stribeck) * (1.0 - way * gear.asymmetry) * gear.terms.friction_drift.factor(session);
        const double command = row.motor_torque * gear.terms.torque_drift.factor(session);
        const double torque = std::min(gear.saturation, command * (1.0 + gear.torque_scale));
        loads.push_back(break_away_load(torque, way, at_rest * gear.coulomb, std::min(0.95, at_rest * gear.load_friction),
                                        at_rest * gear.quadratic, locked));
    }
    return loads;
}

}  // namespace fusee::joint_model
