#include <cmath>

#include "experiments.h"

namespace fusee::joint_model {

namespace {

constexpr double kStrongPush = 1.5;  ///< of the co-contraction, times g, where no push is given

/// dtau_q/dq with both capstans held [Nm/rad].
double held_stiffness(const BuiltRig& rig, const Motion& motion) {
    constexpr double kReach = 0.02;  // rad
    double sum = 0.0;
    for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist}) {
        const BuiltSide& built = rig.sides[static_cast<std::size_t>(side)];
        const CamSpring& spring = built.se;
        const double x = built.capstan_scale * motion.theta(side);
        sum += built.ratio * built.ratio * (spring.torque(x + kReach) - spring.torque(x - kReach)) / (2.0 * kReach);
    }
    return sum;
}

/// Pushes, holds, releases slowly, reads q.
double push_and_release(Motion& motion, const Hand& hand, double cocontraction, double push, const gap_case::Protocol& protocol) {
    motion.lead_smoothly_to({cocontraction, cocontraction, push}, hand.push_share * protocol.dead_band_push);
    motion.hold((1.0 - hand.push_share) * protocol.dead_band_push);
    motion.lead_smoothly_to({cocontraction, cocontraction, 0.0}, (1.0 - hand.settle_share) * protocol.dead_band_release);
    motion.hold(hand.settle_share * protocol.dead_band_release);
    return motion.q();
}

}  // namespace

std::vector<double> predict_dead_band(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    std::vector<double> read;
    const double begin = session_at(rows, protocol, gap_case::Experiment::kDeadBand);
    for (std::size_t i = 0; i < rows.dead_band.size(); ++i) {
        const gap_case::DeadBandRow& row = rows.dead_band[i];
        const double push = std::isfinite(row.push_torque) ? row.push_torque : kStrongPush * rig.mean_ratio() * row.cocontraction;
        Motion motion(rig, step_on(rig.reference, protocol, kDeadBandStep), begin + (i > 0 ? dead_band_until(rows, protocol, i - 1) : 0.0));
        begin_at(motion, {row.cocontraction, row.cocontraction, 0.0}, protocol);
        motion.hand_damping = 2.0 * rig.hand.damping * std::sqrt(held_stiffness(rig, motion) * rig.joint_inertia);
        const double high = push_and_release(motion, rig.hand, row.cocontraction, push, protocol);
        const double low = push_and_release(motion, rig.hand, row.cocontraction, -push, protocol);
        if (rows.dead_band_width_only) {
            read.push_back((1.0 + rig.terms.reading) * (high - low));
            continue;
        }
        read.push_back(rig.read_q(low, 0.0));
        read.push_back(rig.read_q(high, 0.0));
    }
    return read;
}

}  // namespace fusee::joint_model
