#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "by_load.h"
#include "fusee/core/error.h"
#include "fusee/spring/laws.h"
#include "rules.h"

namespace fusee::spring {

namespace {

/// The stiffest K_PE allowed, in units of S: T = 1/1001.
constexpr double kStiffestRatio = 1000.0;

/// P = 2 tau_f/(g DB) and its slope by the load; S as given or chosen.
class Wanted {
public:
    explicit Wanted(const DeadBandLawOptions& options) : options_(options) {
        const double start = options.start_torque, t = options.start_transmission;
        k_ = t / (1.0 - t) * parallel(start).p / (start * start);
    }

    template <class T>
    [[nodiscard]] BasicStiffnesses<T> operator()(const T& tau) const {
        BasicStiffnesses<T> at = parallel(tau);
        at.s = options_.series_stiffness ? math::derivative(*options_.series_stiffness, tau, 0) : k_ * tau * tau;
        at.s_rate = options_.series_stiffness ? math::derivative(*options_.series_stiffness, tau, 1) : 2.0 * k_ * tau;
        return at;
    }
    /// Loads between which the formula is smooth.
    [[nodiscard]] std::vector<double> breaks() const {
        std::vector<double> all = math::breaks(*options_.dead_band);
        for (const double row : options_.friction.rows()) all.push_back(row);
        if (!options_.series_stiffness) return all;
        for (const double place : math::breaks(*options_.series_stiffness)) all.push_back(place);
        return all;
    }
    [[nodiscard]] double dead_band(double tau) const { return options_.dead_band->value(tau); }
    /// The dead-band of a K_PE of kStiffestRatio times S.
    [[nodiscard]] double least(double tau) const {
        return 2.0 * options_.friction.at_rest(tau) / (options_.ratio * kStiffestRatio * (*this)(tau).s);
    }

private:
    template <class T>
    [[nodiscard]] BasicStiffnesses<T> parallel(const T& tau) const {
        const T tau_f = options_.friction.at_rest(tau), width = math::derivative(*options_.dead_band, tau, 0);
        const T p = 2.0 * tau_f / (options_.ratio * width);
        const T growth = options_.friction.slope(tau) / tau_f - math::derivative(*options_.dead_band, tau, 1) / width;
        return {.p = p, .p_rate = p * growth};
    }

    DeadBandLawOptions options_;
    double k_ = 0.0;  ///< of the chosen S = k tau^2
};

void validate(const DeadBandLawOptions& options) {
    const core::Range loads = require_torques(options.start_torque, options.end_torque);
    core::require_positive("rig.ratio", options.ratio);
    require_friction(options.friction, loads);
    require_reach("law.dead_band_deg", *options.dead_band, loads);
    if (options.series_stiffness) return require_reach("law.series_stiffness_Nm_per_rad", *options.series_stiffness, loads);
    core::require_within("law.start_transmission", options.start_transmission, 1.0 / (1.0 + kStiffestRatio), 0.999);
}

/// The finding if the dead-band is narrower than the stiffest K_PE allows.
std::optional<core::Finding> find_too_narrow(const Wanted& wanted, core::Range range) {
    const std::vector<double> loads = scan_loads(range);
    // An invalid series stiffness is another finding.
    const bool stiff = std::all_of(loads.begin(), loads.end(), [&](double tau) { return wanted(tau).s > 0.0; });
    std::vector<LawPoint> points;
    std::vector<double> margins;
    for (const double tau : loads) {
        points.push_back({.tau = tau});
        margins.push_back(wanted.dead_band(tau) - (stiff ? wanted.least(tau) : 0.0));
    }
    const auto broken = [](double margin) { return !(margin > 0.0); };
    const auto first = std::find_if(margins.begin(), margins.end(), broken);
    if (first == margins.end()) return std::nullopt;
    const auto last = std::find_if(margins.rbegin(), margins.rend(), broken).base() - 1;
    const auto worst = std::min_element(margins.begin(), margins.end());
    const double tau = points[static_cast<std::size_t>(worst - margins.begin())].tau, width = wanted.dead_band(tau);
    const double least = core::deg_from_rad(width - *worst);
    core::Finding finding = core::error_finding("law.dead_band", "the wanted dead-band is narrower than the stiffest K_PE gives",
                                                core::deg_from_rad(width), core::Bound::kAtLeast, least, "deg");
    finding.where = fmt::format("law at {:.4g} Nm", tau);
    finding.suggestion =
        nearest_feasible(points, static_cast<std::size_t>(first - margins.begin()), static_cast<std::size_t>(last - margins.begin()))
            .or_else(fmt::format("law.dead_band_deg above {:.4g} at {:.4g} Nm", least, tau));
    finding.source = "docs/theory/springs.md, eq. 20";
    return finding;
}

}  // namespace

core::Outcome<SpringLawPtr> make_dead_band_law(const DeadBandLawOptions& options) {
    validate(options);
    const Wanted wanted(options);
    if (auto narrow = find_too_narrow(wanted, {options.start_torque, options.end_torque})) return *std::move(narrow);
    return integrate_by_load({wanted, wanted.breaks()}, {options.start_torque, options.end_torque});
}

}  // namespace fusee::spring
