#pragma once
#include <vector>

namespace fusee::subsystem {

/// Cycles of a periodic input, and the scatter of the measured column between them.
struct Cycles {
    double period = 0.0;       ///< [s]; 0: input not periodic, or fewer than two whole cycles
    double begin = 0.0;        ///< start of the first cycle in use [s]
    double amplitude = 0.0;    ///< half of the input's range
    std::vector<double> mean;  ///< the loop: mean of the measured column over the cycles, in kPhases bins of one cycle
    double variance = 0.0;     ///< of a row about the mean of its phase over the cycles, unbiased; 0 where there is one cycle only
    std::size_t freedom = 0;   ///< of `variance`: 0 where there is one cycle only
    static constexpr std::size_t kPhases = 64;
};
/// Cycles begin where the input rises through the middle of its range. Cycles that differ from most in duration or range (5 %) are left
/// out: an input that begins from rest and dies out at the end.
/// @pre all of one length, times ascending
[[nodiscard]] Cycles find_cycles(const std::vector<double>& time, const std::vector<double>& input, const std::vector<double>& measured);

/// The first file with the amplitude of `file`, within 5 %.
[[nodiscard]] const Cycles& first_of_same_amplitude(const std::vector<Cycles>& files, const Cycles& file);
/// Variance from one file to the next: of the loops (means over cycles) of files with the same amplitude (5 %) about their mean. A
/// dependence on speed is included if the files differ in frequency. NaN without two such files.
[[nodiscard]] double setup_variance(const std::vector<Cycles>& files);

}  // namespace fusee::subsystem
