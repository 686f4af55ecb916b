#pragma once
#include <array>
#include <string>
#include <vector>

#include "fusee/joint_model/signals.h"

namespace fusee::joint_model {

/// How many times their stated noise the sensors scatter (docs/theory/diagnosis.md, "Noise"): 1 unless the rows show clearly more.
struct Scatter {
    std::array<double, 3> encoder{1.0, 1.0, 1.0};  ///< agonist's capstan, antagonist's capstan, joint: by the rows of logs
    double spring_pull = 1.0;                      ///< by the rows of each curve
    double breakaway = 1.0;                        ///< by repeats of a torque
    std::vector<std::string> remarks;              ///< for the reader, where it is not 1
};

/// Expected deviation of a correct model, row by row: sensors and accuracy of the prediction.
struct Uncertainty {
    Signals sensors;  ///< one sigma of the measurement alone
    Signals sigma;    ///< with the accuracy of the prediction on a faultless rig
    /// Share of independent rows of each experiment: the rows of a path deviate together.
    std::array<double, gap_case::kExperiments> weight{};
    /// A capstan sticks and slips during co-contraction: the moments of its slips are random.
    bool stick_slip = false;
    Scatter scatter;
};
/// With the noise that the rows of the case show.
[[nodiscard]] Uncertainty uncertainty(const gap_case::Case& gap_case);
/// The same with a noise that is known: of rows that were not measured yet.
[[nodiscard]] Uncertainty uncertainty(const gap_case::Case& gap_case, const Scatter& scatter);
/// What the measured rows say. @param stated one sigma of the sensors as stated, row by row
[[nodiscard]] Scatter measured_scatter(const gap_case::Case& gap_case, const Signals& stated);

}  // namespace fusee::joint_model
