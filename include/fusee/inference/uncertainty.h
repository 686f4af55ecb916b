#pragma once
#include "fusee/joint_model/signals.h"

namespace fusee::inference {

/// What a right model may be off by, row by row: sensors, and what the prediction itself leaves out.
struct Uncertainty {
    joint_model::Signals sensors;  ///< one sigma of the measurement alone
    joint_model::Signals sigma;    ///< with the accuracy of the prediction on a faultless rig
    /// Of each experiment, the share of its rows that say something of their own: a path's rows are off together.
    std::array<double, gap_case::kExperiments> weight{};
    /// A capstan stood still again and again while co-contraction went on: the moments of its slips are chance.
    bool stick_slip = false;
};
[[nodiscard]] Uncertainty uncertainty(const gap_case::Case& gap_case);

}  // namespace fusee::inference
