#pragma once
#include "fusee/gap/signals.h"

namespace fusee::gap {

/// What a right model may be off by, row by row: sensors, and what the prediction itself leaves out.
struct Uncertainty {
    Signals sensors;  ///< one sigma of the measurement alone
    Signals sigma;    ///< with the accuracy of the prediction on a faultless rig
    /// Of each experiment, the share of its rows that say something of their own: a path's rows are off together.
    std::array<double, kExperiments> weight{};
    /// A capstan stood still again and again while co-contraction went on: the moments of its slips are chance.
    bool stick_slip = false;
};
[[nodiscard]] Uncertainty uncertainty(const Case& bench);

}  // namespace fusee::gap
