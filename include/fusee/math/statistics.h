#pragma once
#include <cstddef>
#include <vector>

namespace fusee::math {

/// The middle value; of an even count the mean of the two middle ones. @pre not empty
[[nodiscard]] double median(std::vector<double> values);
/// The middle value; of an even count the upper one of the two middle ones. @pre not empty
[[nodiscard]] double upper_median(std::vector<double> values);
/// Linear between the two nearest values; share 0 is the first, 1 the last. @pre sorted, not empty, 0 <= share <= 1
[[nodiscard]] double quantile(const std::vector<double>& sorted, double share);

/// t with P(|T| <= t) = confidence. @pre 0 < confidence < 1, freedom >= 1
[[nodiscard]] double student_quantile(double confidence, std::size_t freedom);
/// P(F > f) of the F distribution. @pre f >= 0
[[nodiscard]] double f_tail(double f, std::size_t numerator_freedom, std::size_t denominator_freedom);

}  // namespace fusee::math
