#include <algorithm>
#include <cmath>

#include "fusee/gap_case/likely_unit.h"
#include "fusee/math/statistics.h"
#include "fusee/simulator/case.h"

namespace fusee::simulator {

namespace {

const double kStepNoise = std::sqrt(12.0);  // of rounding to steps: step/sqrt(12)

}  // namespace

double estimated_noise(const std::vector<const std::vector<double>*>& runs) {
    std::vector<double> all;
    std::vector<math::Series> series;
    for (const std::vector<double>* run : runs) {
        all.insert(all.end(), run->begin(), run->end());
        series.push_back({*run, {}});
    }
    const double noise = math::scatter(series, 3);
    return std::isnan(noise) ? noise : std::max(noise, gap_case::step_of(std::move(all)) / kStepNoise);
}

double measured_noise(const std::vector<const std::vector<double>*>& runs, double stated) {
    std::vector<math::Series> series;
    for (const std::vector<double>* run : runs) series.push_back({*run, std::vector<double>(run->size(), stated)});
    return stated * math::noise_factor(math::least_scatter(series));
}

}  // namespace fusee::simulator
