#pragma once
#include <functional>
#include <string>
#include <vector>

#include "fusee/gap_case/case.h"
#include "fusee/joint_model/built_rig.h"

namespace fusee::joint_model {

/// A value of the built rig that is known only within its tolerance: fitted with every effect, with the tolerance as
/// its prior.
struct BuildParameter {
    std::string name, unit;
    double sigma = 1.0;  ///< in `unit`; of its logarithm where `unit` is "log"
    std::function<void(BuiltRig&, double)> add;
    bool of_rig = true;  ///< false: describes how an experiment was done, not bounded by [tolerance]
};
/// Friction, springs and torque of each side, radii, inertias, bearing friction, encoder zero, and the hand of the dead-band test.
[[nodiscard]] std::vector<BuildParameter> build_parameters(const gap_case::Case& gap_case);

}  // namespace fusee::joint_model
