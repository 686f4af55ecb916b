#pragma once
#include <string>
#include <vector>

/// Questions about the unit of figures that cannot be in the unit of their column.
namespace fusee::gap_case {

/// Another unit in which figures may be: `count` of it make one of the column's own.
struct OtherUnit {
    double count = 1.0;
    const char* question = "";  ///< "are the torques Nmm"
};
/// "; are the torques Nmm?": the unit that makes figures `ratio` times as large as expected, or the nearest to it. "" unless ratio > 0
[[nodiscard]] std::string likely_unit(double ratio, const std::vector<OtherUnit>& units);
/// True if the readings are multiples of `step`, and of at least eight different ones.
[[nodiscard]] bool counted_in(const std::vector<double>& readings, double step);
/// The least difference of two readings, beyond rounding: the step of a sensor that counts. 0 if all are equal.
[[nodiscard]] double step_of(std::vector<double> readings);

}  // namespace fusee::gap_case
