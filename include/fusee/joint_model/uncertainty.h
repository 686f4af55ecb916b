#pragma once
#include "fusee/joint_model/signals.h"

namespace fusee::joint_model {

/// Expected deviation of a correct model, row by row: sensors and accuracy of the prediction.
struct Uncertainty {
    Signals sensors;  ///< one sigma of the measurement alone
    Signals sigma;    ///< with the accuracy of the prediction on a faultless rig
    /// Share of independent rows of each experiment: the rows of a path deviate together.
    std::array<double, gap_case::kExperiments> weight{};
    /// A capstan sticks and slips during co-contraction: the moments of its slips are random.
    bool stick_slip = false;
};
[[nodiscard]] Uncertainty uncertainty(const gap_case::Case& gap_case);

}  // namespace fusee::joint_model
