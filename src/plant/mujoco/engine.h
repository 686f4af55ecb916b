#pragma once

#include "fusee/plant/machine.h"

namespace fusee::plant {

/// What only MuJoCo's rig has (docs/theory/plant.md#in-mujoco).
struct Softness {
    double give = 5e-4;        ///< share of a friction that its creep takes away, 1 - impedance
    double grip_time = 0.003;  ///< in which friction stops a motion [s]
    double stop_time = 0.008;  ///< in which a stop does [s]
    double motor_lag = 0.002;  ///< of a motor's torque behind its command [s]
};
/// Of one rig at random.
[[nodiscard]] Softness draw_softness(Random& random);

/// MuJoCo moves the rig: its integrator, its soft constraints as friction and stops, its actuators; break-away by a load that rises until
/// the capstan turns. Springs, the limit of a friction and the faults are those of Truth.
class MujocoEngine final : public Engine {
public:
    explicit MujocoEngine(const Softness& softness) : softness_(softness) {}
    [[nodiscard]] std::unique_ptr<Motion> start(const Truth& truth, const BuiltSprings& springs, double session) const override;
    [[nodiscard]] double break_away(const SideTruth& side, double motor, bool backdrive, double theta, double scatter,
                                    double session) const override;

private:
    Softness softness_;
};

}  // namespace fusee::plant
