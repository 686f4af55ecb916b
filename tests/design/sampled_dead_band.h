#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/equilibrium.h"
#include "fusee/core/parallel.h"
#include "fusee/design/robust.h"
#include "fusee/math/statistics.h"
#include "fusee/math/stream.h"
#include "fusee/spring/potential.h"

namespace fusee::design {

struct SampleOptions {
    int count = 2000;        ///< actuators, >= 20
    std::uint64_t seed = 1;  ///< of the counter-based streams, one for each actuator
    unsigned jobs = 0;       ///< threads; 0: one for each processor
};

/// The dead-bands of built actuators by Monte Carlo: every spring by make_built_spring, both edges solved.
struct SampledBand {
    double mean = 0.0, sigma = 0.0;  ///< of the actuators whose springs reach both edges [rad]
    core::Range band;                ///< 5th and 95th percentile [rad]
    double covered_share = 0.0;      ///< of all
};

/// Makes random built actuators.
class Shop {
public:
    Shop(const DrawnJoint& drawn, double tau, const ShopScatter& s, std::uint64_t seed)
        : drawn_(drawn),
          tau_(tau),
          scatter_(s),
          seed_(seed),
          series_(spring::resampled(spring::series_spring(drawn.actuator.law))),
          parallel_(spring::resampled(spring::parallel_spring(drawn.actuator.law))) {}

    /// Dead-band of the actuator of that number; NaN if its springs do not reach an edge.
    [[nodiscard]] double width(std::uint64_t number) const {
        const math::Stream stream(seed_, 0, number);
        const actuator::Actuator& rig = drawn_.actuator;
        std::array<spring::PotentialPtr, 2> se, pe;
        std::array<core::Range, 2> loads;
        for (std::size_t side = 0; side < 2; ++side) {
            const auto error = [&](std::size_t i, double sigma) { return sigma * stream.normal(2 * (side * 5 + i)); };
            se[side] = built(series_, drawn_.base_se, error(0, scatter_.rate_se), error(2, scatter_.contour));
            pe[side] = built(parallel_, drawn_.base_pe, error(1, scatter_.rate_pe), error(3, scatter_.contour));
            loads[side] = spring::resting_loads(rig.gear_friction, tau_, std::max(0.0, 1.0 + error(4, scatter_.friction)));
            if (std::isnan(loads[side].width())) return core::kNan;
        }
        const actuator::Joint joint =
            actuator::antagonist(pe[0], se[0], se[1], pe[1], {rig.gear_friction, rig.gear_friction}, rig.capstan_radius, rig.joint_radius);
        const auto high = actuator::find_equilibrium(joint, {loads[0].low, loads[1].high, 0.0});
        const auto low = actuator::find_equilibrium(joint, {loads[0].high, loads[1].low, 0.0});
        return high && low ? high->z(actuator::kOutput) - low->z(actuator::kOutput) : core::kNan;
    }

private:
    [[nodiscard]] spring::PotentialPtr built(const spring::PotentialPtr& law, const spring::BaseSpring& base, double rate,
                                             double radius) const {
        return spring::make_built_spring(law, base, drawn_.actuator.capstan_radius, {.rate = rate, .radius = radius, .preload = 0.0});
    }

    const DrawnJoint& drawn_;
    double tau_;
    ShopScatter scatter_;
    std::uint64_t seed_;
    spring::PotentialPtr series_, parallel_;
};

inline SampledBand sample_dead_band(const DrawnJoint& drawn, double tau, const ShopScatter& scatter, const SampleOptions& options) {
    const Shop shop(drawn, tau, scatter, options.seed);
    std::vector<double> widths(static_cast<std::size_t>(options.count));
    core::parallel_for(widths.size(), options.jobs, [&](std::size_t i) { widths[i] = shop.width(i); });
    std::erase_if(widths, [](double width) { return std::isnan(width); });
    std::sort(widths.begin(), widths.end());
    const double count = static_cast<double>(widths.size());
    SampledBand band;
    band.covered_share = count / options.count;
    for (const double width : widths) band.mean += width / count;
    double squares = 0.0;
    for (const double width : widths) squares += (width - band.mean) * (width - band.mean);
    band.sigma = std::sqrt(squares / (count - 1.0));
    band.band = {math::quantile(widths, 0.05), math::quantile(widths, 0.95)};
    return band;
}

}  // namespace fusee::design
