#include "faultless.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fusee::blind {

Faultless draw_faultless(const gap_case::Case& gap_case, plant::Random& random) {
    const gap_case::Tolerance& t = gap_case.tolerance;
    Faultless rig{gap_case, {}};
    const auto add = [&](const char* id, const char* side, double value) {
        rig.built.effects.push_back({{id, side}, 1.0, {value, {}, {}}, {}});
    };
    for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist})
        for (const auto& [id, sigma] : {std::pair{"gear.load_friction", t.gear_load_friction},
                                        {"se.rate", t.spring_rate},
                                        {"pe.rate", t.spring_rate},
                                        {"se.radius", t.se_radius},
                                        {"pe.radius", t.pe_radius},
                                        {"se.preload", t.se_preload},
                                        {"pe.preload", t.pe_preload},
                                        {"sensor.torque_scale", t.torque_scale}})
            add(id, to_string(side), sigma * random.normal());
    add("sensor.joint_offset", "none", t.joint_offset * random.normal());
    // The nominal bearing friction is one sigma; it cannot be negative.
    add("joint.coulomb", "none", t.joint_coulomb * std::max(-1.0, random.normal()));
    for (const auto& [figure, relative] : {std::pair{&gap_case::NominalRig::capstan_radius, t.radii},
                                           {&gap_case::NominalRig::joint_radius, t.radii},
                                           {&gap_case::NominalRig::motor_inertia, t.inertia},
                                           {&gap_case::NominalRig::joint_inertia, t.inertia}})
        rig.gap_case.rig.*figure *= 1.0 + relative * random.normal();
    return rig;
}

joint_model::Signals sensor_sigma(const gap_case::Case& gap_case, const gap_case::Rows& rows, const joint_model::Signals& exact) {
    const gap_case::Sensors& s = gap_case.sensors;
    const double encoder = std::hypot(s.encoder_noise, s.encoder_step / std::sqrt(12.0)), mu = gap_case.rig.gear_load_friction;
    joint_model::Signals sigma = exact;
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments)
        for (double& figure : sigma[experiment])
            figure = is_read_by_encoder(experiment) ? encoder : std::hypot(s.torque_noise, s.torque_noise_relative * figure);
    std::vector<double>& loads = sigma[gap_case::Experiment::kBreakAway];
    for (std::size_t i = 0; i < loads.size(); ++i) {  // L (1 -+ mu) = tau, and mu scatters
        const double lever = rows.breakaway[i].backdrive ? 1.0 - mu : 1.0 + mu;
        loads[i] = std::hypot(loads[i], s.breakaway_scatter * mu * rows.breakaway[i].motor_torque / (lever * lever));
    }
    return sigma;
}

}  // namespace fusee::blind
