#include <algorithm>
#include <cmath>

#include "experiments.h"

namespace fusee::joint_model {

namespace {

constexpr double kStrongPush = 1.5;  ///< of the co-contraction, times g, where no push is given

/// dtau_q/dq with both capstans held [Nm/rad].
template <class V>
double held_stiffness(const MotionOf<V>& motion, std::size_t i) {
    constexpr double kReach = 0.02;  // rad
    const BuiltRig& rig = *motion.rigs()[i];
    double sum = 0.0;
    for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist}) {
        const BuiltSide& built = rig.sides[static_cast<std::size_t>(side)];
        const CamSpring& spring = built.se;
        const double x = built.capstan_scale * lane(motion.theta(side), i);
        sum += built.ratio * built.ratio * (spring.torque(x + kReach) - spring.torque(x - kReach)) / (2.0 * kReach);
    }
    return sum;
}

/// Pushes, holds, releases slowly, reads q.
template <class V>
V push_and_release(MotionOf<V>& motion, V cocontraction, V push, const gap_case::Protocol& protocol) {
    const V push_share = each<V>([&](std::size_t i) { return motion.rigs()[i]->hand.push_share; });
    const V settle_share = each<V>([&](std::size_t i) { return motion.rigs()[i]->hand.settle_share; });
    motion.lead_smoothly_to({cocontraction, cocontraction, push}, push_share * protocol.dead_band_push);
    motion.hold((1.0 - push_share) * protocol.dead_band_push);
    motion.lead_smoothly_to({cocontraction, cocontraction, V{}}, (1.0 - settle_share) * protocol.dead_band_release);
    motion.hold(settle_share * protocol.dead_band_release);
    return motion.q();
}

/// The first row with the set point of row `i`, which reads the same on a rig that does not drift.
std::size_t first_like(const std::vector<gap_case::DeadBandRow>& rows, std::size_t i) {
    const auto same = [&](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    std::size_t first = 0;
    while (first < i && (rows[first].cocontraction != rows[i].cocontraction || !same(rows[first].push_torque, rows[i].push_torque)))
        ++first;
    return first;
}

template <class V>
bool drifts(const RigsOf<V>& rigs) {
    return std::any_of(rigs.begin(), rigs.end(), [](const BuiltRig* rig) { return rig->drifts(); });
}

}  // namespace

template <class V>
ReadingsOf<V> predict_dead_band(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    ReadingsOf<V> read;
    const double begin = session_at(rows, protocol, gap_case::Experiment::kDeadBand);
    const std::size_t columns = rows.dead_band_width_only ? 1 : 2;
    const bool alike = !drifts<V>(rigs);
    for (std::size_t i = 0; i < rows.dead_band.size(); ++i) {
        const gap_case::DeadBandRow& row = rows.dead_band[i];
        if (const std::size_t first = alike ? first_like(rows.dead_band, i) : i; first < i) {
            for (std::vector<double>& figures : read)
                for (std::size_t c = 0; c < columns; ++c) figures.push_back(figures[first * columns + c]);
            continue;
        }
        const V cocontraction = in_all<V>(row.cocontraction),
                push = each<V>([&](std::size_t l) {
                    return std::isfinite(row.push_torque) ? row.push_torque : kStrongPush * rigs[l]->mean_ratio() * row.cocontraction;
                });
        MotionOf<V> motion(rigs, step_on(rigs[0]->reference, protocol, kDeadBandStep),
                           in_all<V>(begin + (i > 0 ? dead_band_until(rows, protocol, i - 1) : 0.0)));
        begin_at(motion, {cocontraction, cocontraction, V{}}, protocol);
        motion.hand_damping = each<V>(
            [&](std::size_t l) { return 2.0 * rigs[l]->hand.damping * std::sqrt(held_stiffness(motion, l) * rigs[l]->joint_inertia); });
        const V high = push_and_release(motion, cocontraction, push, protocol);
        const V at_high = motion.session();
        const V low = push_and_release(motion, cocontraction, -push, protocol);
        for (std::size_t l = 0; l < read.size(); ++l) {
            const double first = lane(at_high, l), then = lane(motion.session(), l);
            if (rows.dead_band_width_only) {
                const Drift& zero = rigs[l]->terms.zero;
                read[l].push_back((1.0 + rigs[l]->terms.reading) * (lane(high, l) - lane(low, l)) + (zero(first) - zero(then)));
                continue;
            }
            read[l].push_back(rigs[l]->read_q(lane(low, l), 0.0, then));
            read[l].push_back(rigs[l]->read_q(lane(high, l), 0.0, first));
        }
    }
    return read;
}

template ReadingsOf<double> predict_dead_band<double>(const RigsOf<double>&, const gap_case::Rows&, const gap_case::Protocol&);
template ReadingsOf<Lanes> predict_dead_band<Lanes>(const RigsOf<Lanes>&, const gap_case::Rows&, const gap_case::Protocol&);

}  // namespace fusee::joint_model
