#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "experiments.h"
#include "fusee/joint_model/motion.h"
#include "fusee/joint_model/signals.h"

// What moves: dead-bands, stiffness, co-contraction and logs. Of one rig, or of four of one case: V = double or Lanes.
namespace fusee::joint_model {

namespace {

/// The predicted values of each rig.
template <class V>
using ReadingsOf = std::array<std::vector<double>, kWidth<V>>;

/// Appends what the joint's encoder of each rig reads now.
template <class V>
void append_q(const MotionOf<V>& motion, ReadingsOf<V>& read) {
    for (std::size_t i = 0; i < read.size(); ++i)
        read[i].push_back(motion.rigs()[i]->read_q(lane(motion.q(), i), lane(motion.joint_torque(), i), lane(motion.session(), i)));
}
/// Appends what the encoders read: theta_agonist, theta_antagonist behind backlash, q with its offset; generic terms of each.
template <class V>
void append_reading(const MotionOf<V>& motion, ReadingsOf<V>& read) {
    for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist})
        for (std::size_t i = 0; i < read.size(); ++i) {
            const Ripple& reading = motion.rigs()[i]->sides[static_cast<std::size_t>(side)].gear.terms.reading;
            read[i].push_back(lane(motion.encoder(side), i) + (reading.is_on() ? reading(lane(motion.theta(side), i)) : 0.0));
        }
    append_q(motion, read);
}

/// Leads the motion from rest to the first torques of an experiment by the protocol, then settling.
template <class V>
void begin_at(MotionOf<V>& motion, const typename MotionOf<V>::Torques& torques, const gap_case::Protocol& protocol) {
    if (protocol.smooth_motor_ramp)
        motion.lead_smoothly_to(torques, in_all<V>(protocol.motor_ramp));
    else
        motion.lead_to(torques, in_all<V>(protocol.motor_ramp));
    motion.hold(in_all<V>(protocol.motor_settle));
}

/// The rows of each file of an experiment: each begins from rest. Rows beyond the files are one more part.
template <class Row>
std::vector<std::span<const Row>> files_of(const gap_case::Rows& rows, gap_case::Experiment experiment, const std::vector<Row>& all) {
    std::vector<std::span<const Row>> files;
    std::span<const Row> left(all);
    const auto parts = rows.parts.find(experiment);
    if (parts != rows.parts.end())
        for (const std::size_t count : parts->second) {
            if (count > 0) files.push_back(left.first(count));
            left = left.subspan(count);
        }
    if (!left.empty()) files.push_back(left);
    return files;
}

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

template <class V>
ReadingsOf<V> predict_dead_band(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol, double session) {
    ReadingsOf<V> read;
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
                           in_all<V>(session + (i > 0 ? dead_band_until(rows, protocol, i - 1) : 0.0)));
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

/// Rows from row `first` to row `i`, those that were left out included.
double place_in(std::span<const gap_case::StiffnessRow> rows, std::size_t first, std::size_t i) {
    return static_cast<double>(rows[i].row > 0 ? rows[i].row - rows[first].row : i - first);
}

/// Line through the torques of a phase: the command without the scatter of its reading.
struct Ramp {
    double from = 0.0, per_row = 0.0;
};
Ramp straight(std::span<const gap_case::StiffnessRow> rows, std::size_t first, std::size_t last) {
    const double n = static_cast<double>(last - first);
    double mean = 0.0, middle = 0.0, lever = 0.0, weight = 0.0;
    for (std::size_t i = first; i < last; ++i) {
        mean += rows[i].joint_torque / n;
        middle += place_in(rows, first, i);
    }
    middle /= n;
    for (std::size_t i = first; i < last; ++i) {
        const double place = place_in(rows, first, i) - middle;
        lever += place * rows[i].joint_torque;
        weight += place * place;
    }
    const double per_row = weight > 0.0 ? lever / weight : 0.0;
    return {mean - per_row * middle, per_row};
}

/// One file: each co-contraction from rest, then its phases in order.
template <class V>
void follow_stiffness(const RigsOf<V>& rigs, std::span<const gap_case::StiffnessRow> rows, const gap_case::Protocol& protocol,
                      double session, ReadingsOf<V>& read) {
    const double step = step_on(rigs[0]->reference, protocol, kSlowStep);
    MotionOf<V> motion(rigs, step, in_all<V>(session));
    for (std::size_t first = 0, last = 0; first < rows.size(); first = last) {
        const gap_case::StiffnessRow& begin = rows[first];
        while (last < rows.size() && rows[last].cocontraction == begin.cocontraction && rows[last].phase == begin.phase) ++last;
        const V tau = in_all<V>(begin.cocontraction);
        if (first == 0 || begin.cocontraction != rows[first - 1].cocontraction) {
            motion = MotionOf<V>(rigs, step, motion.session());
            begin_at(motion, {tau, tau, V{}}, protocol);
        }
        const Ramp ramp = straight(rows, first, last);
        const double of_phase = place_in(rows, first, last - 1) + 1.0;
        for (std::size_t i = first; i < last; ++i) {
            const double place = place_in(rows, first, i), steps = i == first ? 1.0 : place - place_in(rows, first, i - 1);
            motion.lead_to({tau, tau, in_all<V>(ramp.from + ramp.per_row * place)},
                           in_all<V>(steps * (protocol.joint_stiffness_phase / of_phase)));
            append_q(motion, read);
        }
    }
}

/// One file from rest. The greatest torque of all files takes one phase.
template <class V>
void follow_cocontraction(double greatest, const RigsOf<V>& rigs, std::span<const gap_case::CocontractionRow> rows,
                          const gap_case::Protocol& protocol, double session, ReadingsOf<V>& read) {
    MotionOf<V> motion(rigs, step_on(rigs[0]->reference, protocol, kSlowStep), in_all<V>(session));
    const double seconds_per_torque = protocol.cocontraction_phase / greatest;
    double torque = 0.0;
    for (const gap_case::CocontractionRow& row : rows) {
        const V both = in_all<V>(row.motor_torque);
        motion.lead_to({both, both, V{}}, in_all<V>(seconds_per_torque * std::abs(row.motor_torque - torque)));
        torque = row.motor_torque;
        append_reading(motion, read);
    }
}

template <class V>
typename MotionOf<V>::Torques torques_of(double agonist, double antagonist, double joint) {
    return {in_all<V>(agonist), in_all<V>(antagonist), in_all<V>(joint)};
}
template <class V>
typename MotionOf<V>::Torques torques_of(const gap_case::LogRow& row) {
    return torques_of<V>(row.torque_agonist, row.torque_antagonist, row.joint_torque);
}

/// Every third of `read`, q, as it was `lag` before its row.
void delay_q(std::span<const gap_case::LogRow> rows, double lag, std::span<double> read) {
    std::vector<double> q;
    for (std::size_t i = 2; i < read.size(); i += 3) q.push_back(read[i]);
    std::size_t after = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double time = rows[i].time - lag;
        while (after + 1 < rows.size() && rows[after].time < time) ++after;
        const std::size_t before = after > 0 ? after - 1 : 0;
        const double width = rows[after].time - rows[before].time;
        const double share = width > 0.0 ? std::clamp((time - rows[before].time) / width, 0.0, 1.0) : 0.0;
        read[3 * i + 2] = std::lerp(q[before], q[after], share);
    }
}

/// One log from rest: the motor ramp reaches the torques of the first row, which settle before the log begins.
template <class V>
void follow_log(const RigsOf<V>& rigs, std::span<const gap_case::LogRow> rows, const gap_case::Protocol& protocol, double session,
                ReadingsOf<V>& read) {
    MotionOf<V> motion(rigs, step_on(rigs[0]->reference, protocol, kLogStep), in_all<V>(session));
    const gap_case::LogRow& first = rows.front();
    begin_at(motion, torques_of<V>(first), protocol);
    std::size_t next = 1;
    double now = first.time;  // commands after the `delay`
    const auto lead_to = [&](const typename MotionOf<V>::Torques& command, double time) {
        motion.lead_to(command, in_all<V>(time - now));
        now = time;
    };
    for (const gap_case::LogRow& row : rows) {
        const double sent = row.time - rigs[0]->delay;  // command that acts at this row
        for (; next < rows.size() && rows[next].time <= sent; ++next)
            if (rows[next].time > now) lead_to(torques_of<V>(rows[next]), rows[next].time);
        if (sent > now && next < rows.size()) {
            const gap_case::LogRow &before = rows[next - 1], &after = rows[next];
            const double share = (sent - before.time) / (after.time - before.time);
            lead_to(torques_of<V>(std::lerp(before.torque_agonist, after.torque_agonist, share),
                                  std::lerp(before.torque_antagonist, after.torque_antagonist, share),
                                  std::lerp(before.joint_torque, after.joint_torque, share)),
                    sent);
        }
        append_reading(motion, read);
    }
    for (std::size_t i = 0; i < read.size(); ++i)
        if (rigs[i]->terms.lag > 0.0) delay_q(rows, rigs[i]->terms.lag, std::span(read[i]).last(3 * rows.size()));
}

template <class V>
ReadingsOf<V> predict_motion(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol,
                             gap_case::Experiment experiment) {
    const double session = session_at(rows, protocol, experiment);
    const auto over_files = [&](const auto& all, const auto& follow) {
        ReadingsOf<V> read;
        for (const auto& file : files_of(rows, experiment, all)) follow(rigs, file, protocol, session, read);
        return read;
    };
    switch (experiment) {
        case gap_case::Experiment::kDeadBand:
            return predict_dead_band<V>(rigs, rows, protocol, session);
        case gap_case::Experiment::kJointStiffness:
            return over_files(rows.joint_stiffness, follow_stiffness<V>);
        case gap_case::Experiment::kCocontraction: {
            double greatest = 1e-9 * rigs[0]->reference.torque;
            for (const gap_case::CocontractionRow& row : rows.cocontraction) greatest = std::max(greatest, std::abs(row.motor_torque));
            return over_files(rows.cocontraction, [&](auto&&... of_file) { follow_cocontraction<V>(greatest, of_file...); });
        }
        default:
            return over_files(rows.log, follow_log<V>);
    }
}

/// The places of rigs that can be led together: those of a log have one delay, because commands act between the same rows.
std::vector<std::vector<std::size_t>> like_delays(std::span<const BuiltRig> rigs, gap_case::Experiment experiment) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < rigs.size(); ++i) {
        const auto group = std::find_if(groups.begin(), groups.end(), [&](const std::vector<std::size_t>& others) {
            return experiment != gap_case::Experiment::kLog || rigs[others.front()].delay == rigs[i].delay;
        });
        if (group == groups.end())
            groups.push_back({i});
        else
            group->push_back(i);
    }
    return groups;
}

}  // namespace

std::vector<double> predict_experiment(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol,
                                       gap_case::Experiment experiment) {
    if (experiment == gap_case::Experiment::kBreakAway) return predict_break_away(rig, rows.breakaway, protocol);
    if (experiment == gap_case::Experiment::kSpringPull) return predict_spring_pull(rig, rows, protocol);
    return predict_motion<double>({&rig}, rows, protocol, experiment)[0];
}

std::vector<std::vector<double>> predict_experiment(std::span<const BuiltRig> rigs, const gap_case::Rows& rows,
                                                    const gap_case::Protocol& protocol, gap_case::Experiment experiment) {
    if (rigs.size() == 1) return {predict_experiment(rigs[0], rows, protocol, experiment)};
    std::vector<std::vector<double>> all(rigs.size());
    const bool moves = experiment != gap_case::Experiment::kBreakAway && experiment != gap_case::Experiment::kSpringPull;
    for (const std::vector<std::size_t>& group : like_delays(rigs, experiment))
        for (std::size_t first = 0; first < group.size(); first += kWidth<Lanes>) {
            const std::size_t here = std::min(kWidth<Lanes>, group.size() - first);
            if (!moves || here == 1) {
                for (std::size_t i = 0; i < here; ++i)
                    all[group[first + i]] = predict_experiment(rigs[group[first + i]], rows, protocol, experiment);
                continue;
            }
            RigsOf<Lanes> four{};
            for (std::size_t l = 0; l < four.size(); ++l) four[l] = &rigs[group[first + std::min(l, here - 1)]];
            ReadingsOf<Lanes> read = predict_motion<Lanes>(four, rows, protocol, experiment);
            for (std::size_t l = 0; l < here; ++l) all[group[first + l]] = std::move(read[l]);
        }
    return all;
}

}  // namespace fusee::joint_model
