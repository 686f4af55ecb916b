#include "fusee/design/algorithm_1.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"

// Equation numbers: docs/theory/algorithm_1.md.
namespace fusee::design {

namespace {

constexpr double kLargestSetting = 1e9, kLeastK = 1e-9;
constexpr int kMostLevels = 100000;

void require_box(const std::string& name, const core::Range& box, double least) {
    if (std::isfinite(box.low) && std::isfinite(box.high) && box.low >= least && box.low <= box.high && box.high <= kLargestSetting) return;
    throw core::InvalidInput(name, fmt::format("[{:g}, {:g}]", box.low, box.high),
                             fmt::format("two numbers from {:g} to {:g}, the lower first", least, kLargestSetting));
}

void validate(const Algorithm1Options& o, const Algorithm1Rig& rig) {
    require_box("algorithm_1.k_per_Nm_rad", o.k, kLeastK);
    require_box("algorithm_1.u_Nm", o.u, -kLargestSetting);
    require_box("algorithm_1.c_Nm", o.c, -kLargestSetting);
    core::require_within("algorithm_1.torques", o.torques, 2, kMostLevels);
    core::require_positive("algorithm_1.wanted_travel_deg", o.wanted_travel, "rad");
    core::require_positive("algorithm_1.joint_range_deg", o.joint_range, "rad");
    core::require_within("algorithm_1.weight_travel_per_rad", o.weight_travel, 0.0, kLargestSetting);
    core::require_within("algorithm_1.weight_dead_band_per_rad", o.weight_dead_band, 0.0, kLargestSetting);
    core::require_within("algorithm_1.weight_sensitivity_Nm_per_rad", o.weight_sensitivity, 0.0, kLargestSetting);
    core::require_positive("rig.gear_friction", rig.mu);
    core::require_positive("rig.ratio", rig.ratio);
    core::require_positive("torques.low", rig.torques.low, "Nm");
    if (!(rig.torques.high > rig.torques.low && rig.torques.high < kLargestSetting))
        throw core::InvalidInput("rig.peak_torque_Nm", fmt::format("{:g}", rig.torques.high),
                                 fmt::format("above the least co-contraction, {:g} Nm", rig.torques.low));
    core::require_within("highest_load", rig.highest_load, rig.torques.high, kLargestSetting, "Nm");
}

/// eq. 2: (1/T - 1) k tau^2 with T = (a + C tau)/tau^2
double parallel_stiffness(double k, double a, double c, double tau) {
    const double square = tau * tau, down = a + c * tau;
    return k * square * (square - down) / down;
}

}  // namespace

Algorithm1::Algorithm1(const Algorithm1Options& options, const Algorithm1Rig& rig) : options_(options), rig_(rig) {
    validate(options, rig);
    for (int i = 0; i < options.torques; ++i)
        loads_.push_back(i + 1 == options.torques ? rig.torques.high : rig.torques.low + rig.torques.width() * i / (options.torques - 1));
    if (rig.highest_load > rig.torques.high) loads_.push_back(rig.highest_load);
    const double s = 1.0 / rig.torques.low, e = 1.0 / rig.torques.high;
    i3_ = (s * s - e * e) / 2.0;
    i4_ = (s * s * s - e * e * e) / 3.0;
}

/// eq. 2 over all loads.
double Algorithm1::least_stiffness(double k, double a, double c) const {
    double least = std::numeric_limits<double>::infinity();
    for (const double tau : loads_) {
        const double parallel = a + c * tau == 0.0 ? -std::numeric_limits<double>::infinity() : parallel_stiffness(k, a, c, tau);
        least = std::min({least, k * tau * tau, parallel});
    }
    return least;
}

/// eq. 3: both conditions hold at every load if they hold at the ends.
bool Algorithm1::feasible(double k, double a, double c) const {
    const double low = loads_.front(), down = a + c * low;
    return k > 0.0 && down > 0.0 && a + c * loads_.back() > 0.0 && low * low > down;
}

/// eq. 4 to 7
Algorithm1Terms Algorithm1::second_stage(double k, double a, double c) const {
    const auto dead_band = [&](double tau) {
        return std::min(options_.joint_range, 2.0 * rig_.mu * tau / (rig_.ratio * parallel_stiffness(k, a, c, tau)));
    };
    const double peak = rig_.torques.high, s = k * peak * peak, p = parallel_stiffness(k, a, c, peak);
    Algorithm1Terms terms;
    terms.feasible = true;
    terms.travel = (a * i4_ + c * i3_) / k;
    terms.initial_dead_band = dead_band(rig_.torques.low);
    terms.final_dead_band = dead_band(peak);
    terms.sensitivity = (s + p) / (2.0 * rig_.ratio * rig_.ratio * s * p);
    terms.cost = weighed(terms.travel, terms.initial_dead_band, terms.final_dead_band, terms.sensitivity);
    return terms;
}

double Algorithm1::weighed(double travel, double initial_dead_band, double final_dead_band, double sensitivity) const {
    return options_.weight_travel * std::abs(travel - options_.wanted_travel) +
           options_.weight_dead_band * (final_dead_band - initial_dead_band) + options_.weight_sensitivity * sensitivity;
}

double Algorithm1::operator()(std::span<const double> x) const {
    const double k = x[0], a = x[1] * x[1] / rig_.mu, c = x[2];
    return feasible(k, a, c) ? second_stage(k, a, c).cost : std::abs(least_stiffness(k, a, c));
}

Algorithm1Terms Algorithm1::terms(std::span<const double> x) const {
    const double k = x[0], a = x[1] * x[1] / rig_.mu, c = x[2];
    Algorithm1Terms terms;
    if (feasible(k, a, c)) terms = second_stage(k, a, c);
    terms.least_stiffness = least_stiffness(k, a, c);
    if (!terms.feasible) terms.cost = std::abs(terms.least_stiffness);
    return terms;
}

std::array<CostScan, 3> scan_costs(const Algorithm1& algorithm, std::span<const double> optimum, int count) {
    if (count < 2) throw core::InvalidInput("count", fmt::format("{}", count), "at least 2 points");
    std::array<CostScan, 3> scans{{{"k", {}, {}, {}}, {"u", {}, {}, {}}, {"C", {}, {}, {}}}};
    const std::vector<core::Range> bounds = algorithm.bounds();
    for (std::size_t j = 0; j < scans.size(); ++j) {
        core::Range range = bounds[j];
        if (j == 1) range.low = -(range.high = std::max(std::abs(range.low), std::abs(range.high)));
        std::vector<double> x(optimum.begin(), optimum.end());
        for (int i = 0; i < count; ++i) {
            x[j] = range.low + range.width() * i / (count - 1);
            const Algorithm1Terms terms = algorithm.terms(x);
            scans[j].value.push_back(x[j]);
            scans[j].cost.push_back(terms.cost);
            scans[j].feasible.push_back(terms.feasible);
        }
    }
    return scans;
}

}  // namespace fusee::design
