#pragma once
#include <cmath>

#include "fusee/plant/case_files.h"

namespace fusee::plant {

/// One session of all experiments: their common state.
class Session {
public:
    Session(const TestRig& test_rig, const SetPoints& points, Random& random, double begin, const Engine& engine)
        : engine_(engine),
          test_rig_(test_rig),
          points_(points),
          range_(range_of(test_rig.nominal)),
          springs_(test_rig.nominal, test_rig.truth),
          random_(random),
          now_(begin) {}

    [[nodiscard]] std::vector<BreakAwayRow> break_away();
    [[nodiscard]] std::vector<PullRow> spring_pull();
    [[nodiscard]] std::vector<DeadBandRow> dead_band();
    [[nodiscard]] std::vector<StiffnessRow> joint_stiffness();
    [[nodiscard]] std::vector<CocontractionRow> cocontraction();
    [[nodiscard]] std::vector<LogRow> log();

private:
    // Sensors.
    [[nodiscard]] double encoder(double angle) {
        const double step = test_rig_.sensors.encoder_step;
        return step * std::round((angle + test_rig_.sensors.encoder_noise * random_.normal()) / step);
    }
    [[nodiscard]] double torque_sensor(double torque) {
        const Sensors& s = test_rig_.sensors;
        return torque * (1.0 + s.torque_noise_relative * random_.normal()) + s.torque_noise * random_.normal();
    }
    [[nodiscard]] double read_theta(const Motion& rig, std::size_t side) {
        const SideTruth& built = test_rig_.truth.sides[side];
        const double theta = rig.theta(side);
        // The disc's eccentric shift is 0 where the encoder was zeroed.
        const double shift = built.eccentricity * (std::sin(theta + built.eccentricity_phase) - std::sin(built.eccentricity_phase));
        return encoder(theta + shift);
    }
    [[nodiscard]] double read_q(const Motion& rig) {
        const JointTruth& joint = test_rig_.truth.joint;
        const double q = rig.q();
        const double shift = joint.eccentricity * (std::sin(q + joint.eccentricity_phase) - std::sin(joint.eccentricity_phase)) +
                             warmed(joint.zero_drift, joint.zero_time, rig.session());
        return encoder(joint.encoder_scale * q + shift + joint.flexibility * rig.joint_torque() + joint.encoder_offset);
    }
    // Phases.
    [[nodiscard]] std::unique_ptr<Motion> co_contracted(double torque, double hand);
    [[nodiscard]] double hand(double cocontraction) const;
    [[nodiscard]] double pushed_and_released(Motion& rig, double cocontraction, double push);
    void end(const Motion& rig) { now_ = rig.session(); }
    void pull_spring(bool series, std::size_t side, std::vector<PullRow>& rows);
    [[nodiscard]] Command log_command(double t, double knock) const;

    const Engine& engine_;
    const TestRig& test_rig_;
    const SetPoints& points_;
    RigRange range_;
    BuiltSprings springs_;
    Random& random_;
    double now_;
};

}  // namespace fusee::plant
