#pragma once
#include <utility>

#include "fusee/actuator/joint.h"

namespace fusee::actuator {

constexpr double kMu = 0.28;

/// Joint and capstan of one radius, so that widths at the joint are those at the capstan.
inline Actuator with_law(spring::SpringLawPtr law, double mu = kMu, double ratio = 1.0) {
    return {.law = std::move(law),
            .capstan_radius = 0.03,
            .joint_radius = 0.03 * ratio,
            .gear_friction = spring::FrictionLaw::proportional(mu),
            .least_torque = 0.8,
            .peak_torque = 1.0,
            .overdrive_torque = 1.5};
}

}  // namespace fusee::actuator
