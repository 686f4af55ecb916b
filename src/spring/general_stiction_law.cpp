#include "by_load.h"
#include "fusee/spring/laws.h"
#include "rules.h"

namespace fusee::spring {

core::Outcome<SpringLawPtr> make_general_stiction_law(const GeneralStictionOptions& options) {
    const FrictionLaw friction = options.friction;
    validate({.k = options.k,
              .u = options.u,
              .c = options.c,
              .mu = friction.mu(),
              .start_torque = options.start_torque,
              .end_torque = options.end_torque});
    require_friction(friction, {options.start_torque, options.end_torque});
    const double k = options.k, reduced = options.u * options.u, constant = options.c * friction.mu();
    const auto at = [=]<class T>(const T& tau) {
        const T tau_f = friction.at_rest(tau);
        const T t = (constant + reduced / tau) / tau_f;  // T tau_f = mu C + u^2/tau
        const T t_rate = -reduced / (tau * tau * tau_f) - t * friction.slope(tau) / tau_f;
        return from_transmission<T>(k * tau * tau, 2.0 * k * tau, t, t_rate);
    };
    return integrate_by_load({at, friction.rows()}, {options.start_torque, options.end_torque});
}

}  // namespace fusee::spring
