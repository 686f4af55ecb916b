#include <algorithm>
#include <cmath>

#include "fusee/math/statistics.h"
#include "fusee/simulator/case.h"

namespace fusee::simulator {

namespace {

const double kStepNoise = std::sqrt(12.0);  // of rounding to steps: step/sqrt(12)

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
    std::vector<double> all;
    std::vector<math::Series> series;
    for (const std::vector<double>* run : runs) {
        all.insert(all.end(), run->begin(), run->end());
        series.push_back({*run, {}});
    }
    const double noise = math::scatter(series, 3);
    return std::isnan(noise) ? noise : std::max(noise, step_of(std::move(all)) / kStepNoise);
}

double measured_noise(const std::vector<const std::vector<double>*>& runs, double stated) {
    std::vector<math::Series> series;
    for (const std::vector<double>* run : runs) series.push_back({*run, std::vector<double>(run->size(), stated)});
    return stated * math::noise_factor(math::least_scatter(series));
}

}  // namespace fusee::simulator
