#include <algorithm>
#include <cmath>

#include "fusee/simulator/case.h"

namespace fusee::simulator {

namespace {

constexpr std::size_t kFewestDifferences = 16;
const double kNormalQuartile = 0.6744898;         // median of |x| of a standard normal variable
const double kThirdDifference = std::sqrt(20.0);  // of white noise: 1 + 9 + 9 + 1
const double kStepNoise = std::sqrt(12.0);        // of rounding to steps: step/sqrt(12)

/// The least distance of two values that differ; 0: they are all the same.
double step_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const double span = values.empty() ? 0.0 : values.back() - values.front();
    double step = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double apart = values[i] - values[i - 1];
        if (apart > 1e-9 * span && (step == 0.0 || apart < step)) step = apart;
    }
    return step;
}

}  // namespace

double estimated_noise(const std::vector<const std::vector<double>*>& runs) {
    std::vector<double> all, thirds;
    for (const std::vector<double>* run : runs) {
        all.insert(all.end(), run->begin(), run->end());
        for (std::size_t i = 3; i < run->size(); ++i)
            thirds.push_back(std::abs((*run)[i] - 3.0 * (*run)[i - 1] + 3.0 * (*run)[i - 2] - (*run)[i - 3]));
    }
    if (thirds.size() < kFewestDifferences) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = thirds.begin() + static_cast<std::ptrdiff_t>(thirds.size() / 2);
    std::nth_element(thirds.begin(), middle, thirds.end());
    return std::max(*middle / (kNormalQuartile * kThirdDifference), step_of(std::move(all)) / kStepNoise);
}

}  // namespace fusee::simulator
