#include <algorithm>
#include <cmath>

#include "experiments.h"

namespace fusee::joint_model {

namespace {

/// One file from rest. The greatest torque of all files takes one phase.
template <class V>
void follow_cocontraction(std::span<const gap_case::CocontractionRow> rows, double seconds_per_torque, MotionOf<V> motion,
                          ReadingsOf<V>& read) {
    double torque = 0.0;
    for (const gap_case::CocontractionRow& row : rows) {
        const V both = in_all<V>(row.motor_torque);
        motion.lead_to({both, both, V{}}, in_all<V>(seconds_per_torque * std::abs(row.motor_torque - torque)));
        torque = row.motor_torque;
        append_reading(motion, read);
    }
}

}  // namespace

template <class V>
ReadingsOf<V> predict_cocontraction(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol) {
    double most = 1e-9 * rigs[0]->reference.torque;
    for (const gap_case::CocontractionRow& row : rows.cocontraction) most = std::max(most, std::abs(row.motor_torque));
    ReadingsOf<V> read;
    const MotionOf<V> at_rest(rigs, step_on(rigs[0]->reference, protocol, kSlowStep),
                              in_all<V>(session_at(rows, protocol, gap_case::Experiment::kCocontraction)));
    for (const std::span<const gap_case::CocontractionRow> file : files_of(rows, gap_case::Experiment::kCocontraction, rows.cocontraction))
        follow_cocontraction<V>(file, protocol.cocontraction_phase / most, at_rest, read);
    return read;
}

template ReadingsOf<double> predict_cocontraction<double>(const RigsOf<double>&, const gap_case::Rows&, const gap_case::Protocol&);
template ReadingsOf<Lanes> predict_cocontraction<Lanes>(const RigsOf<Lanes>&, const gap_case::Rows&, const gap_case::Protocol&);

}  // namespace fusee::joint_model
