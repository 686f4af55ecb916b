#include "experiments.h"

namespace fusee::joint_model {

namespace {

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

}  // namespace

template <class V>
ReadingsOf<V> predict_joint_stiffness(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    ReadingsOf<V> read;
    const double session = session_at(rows, protocol, gap_case::Experiment::kJointStiffness);
    for (const std::span<const gap_case::StiffnessRow> file : files_of(rows, gap_case::Experiment::kJointStiffness, rows.joint_stiffness))
        follow_stiffness<V>(rigs, file, protocol, session, read);
    return read;
}

template ReadingsOf<double> predict_joint_stiffness<double>(const RigsOf<double>&, const gap_case::Rows&, const gap_case::Protocol&);
template ReadingsOf<Lanes> predict_joint_stiffness<Lanes>(const RigsOf<Lanes>&, const gap_case::Rows&, const gap_case::Protocol&);

}  // namespace fusee::joint_model
