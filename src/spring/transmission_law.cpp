#include "by_load.h"
#include "fusee/core/error.h"
#include "fusee/spring/laws.h"
#include "rules.h"

namespace fusee::spring {

core::Outcome<SpringLawPtr> make_transmission_law(math::CurvePtr series_stiffness, math::CurvePtr transmission, double start_torque,
                                                  double end_torque) {
    const core::Range loads = require_torques(start_torque, end_torque);
    require_reach("law.series_stiffness_Nm_per_rad", *series_stiffness, loads);
    require_reach("law.transmission", *transmission, loads);
    std::vector<double> places = math::breaks(*series_stiffness);
    for (const double place : math::breaks(*transmission)) places.push_back(place);
    const auto at = [s = std::move(series_stiffness), t = std::move(transmission)](const auto& tau) {
        using math::derivative;
        return from_transmission(derivative(*s, tau, 0), derivative(*s, tau, 1), derivative(*t, tau, 0), derivative(*t, tau, 1));
    };
    return integrate_by_load({at, std::move(places)}, {loads.low, loads.high});
}

}  // namespace fusee::spring
