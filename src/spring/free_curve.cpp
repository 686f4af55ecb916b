#include <fmt/format.h>

#include <cmath>

#include "by_load.h"
#include "fusee/core/error.h"
#include "fusee/spring/laws.h"
#include "rules.h"

namespace fusee::spring {

namespace {

void require_knots(const FreeCurveOptions& options) {
    const auto& [loads, stiffness, transmission] = options;
    math::require_table(loads, stiffness, 4, "law.loads_Nm", "law.series_Nm_per_rad");
    math::require_table(loads, transmission, 4, "law.loads_Nm", "law.transmission");
    require_torques(loads.front(), loads.back());
    for (std::size_t i = 0; i < loads.size(); ++i) {
        core::require_positive(fmt::format("law.series_Nm_per_rad[{}]", i), stiffness[i], "Nm/rad");
        if (!(transmission[i] > 0.0 && transmission[i] < 1.0))
            throw core::InvalidInput(fmt::format("law.transmission[{}]", i), fmt::format("{:g}", transmission[i]), "above 0 and below 1");
    }
}

}  // namespace

core::Outcome<SpringLawPtr> make_free_curve(const FreeCurveOptions& options) {
    require_knots(options);
    std::vector<double> log_s, log_ratio;  // ln S, ln(S/P)
    for (const double s : options.series_stiffness) log_s.push_back(std::log(s));
    for (const double t : options.transmission) log_ratio.push_back(std::log(t / (1.0 - t)));
    const auto at = [s_curve = math::make_interpolant(options.loads, log_s),
                     ratio_curve = math::make_interpolant(options.loads, log_ratio)]<class T>(const T& tau) {
        using math::derivative, std::exp;
        const T s = exp(derivative(*s_curve, tau, 0)), p = s * exp(-derivative(*ratio_curve, tau, 0));
        const T s_growth = derivative(*s_curve, tau, 1);
        return BasicStiffnesses<T>{s, p, s * s_growth, p * (s_growth - derivative(*ratio_curve, tau, 1))};
    };
    constexpr bool kPositive = true;  // for any knots
    return integrate_by_load({at, options.loads}, options.loads, kPositive);
}

}  // namespace fusee::spring
