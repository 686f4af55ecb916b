#include "key.h"

namespace fusee::profile {

#define FIELD(member) \
    [](auto& p) -> auto& { return p.member; }

std::vector<Key> simulation_keys() {
    const Limits inertia = above(0, 1e4), viscous = above(0, 1e6), noise = within(0, 1e6);
    return {
        number("dynamics.motor_inertia_kgm2", kKgm2, inertia, "of motor and gear at the capstan; default assumed",
               FIELD(dynamics.motor_inertia)),
        number("dynamics.joint_inertia_kgm2", kKgm2, inertia, "of the moved link; default assumed", FIELD(dynamics.joint_inertia)),
        number("dynamics.motor_viscous_Nms", kNms, viscous, "drag per rad/s at the capstan; default assumed",
               FIELD(dynamics.motor_viscous)),
        number("dynamics.joint_viscous_Nms", kNms, viscous, "drag per rad/s at the joint; default assumed", FIELD(dynamics.joint_viscous)),
        number("dynamics.motor_noise_Nm2s", kNm2s, noise,
               "spectral density (two-sided) of white torque noise at each capstan; default assumed", FIELD(dynamics.motor_noise)),
        number("dynamics.joint_noise_Nm2s", kNm2s, noise, "the same at the joint; default assumed", FIELD(dynamics.joint_noise)),
        integer("simulate.levels", within(2, 1000), "levels of co-contraction, from least to overdrive torque", FIELD(simulate.levels)),
        number("simulate.push_torque_Nm", kNm, within(0, 1e4), "of the push-and-release test, at the joint; 0 = strong enough",
               FIELD(simulate.push_torque)),
        file("simulate.measured", "measured dead-band: CSV in the profile's folder with tau_Nm,width_deg (full width at the joint)",
             FIELD(simulate.measured.file)),
    };
}

#undef FIELD

}  // namespace fusee::profile
