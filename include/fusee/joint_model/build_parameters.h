#pragma once
#include <functional>
#include <string>
#include <vector>

#include "fusee/gap_case/case.h"
#include "fusee/joint_model/built_rig.h"

namespace fusee::joint_model {

/// A figure of the rig as built that its maker cannot know better than by its tolerance: fitted beside every effect, with the tolerance as
/// its prior.
struct BuildParameter {
    std::string name, unit;
    double sigma = 1.0;  ///< in `unit`; of its logarithm where `unit` is "log"
    std::function<void(BuiltRig&, double)> add;
    bool of_rig = true;  ///< else of how an experiment was done: nothing that [tolerance] bounds
};
/// Friction, springs and torque of each side, radii, inertias, bearing friction, encoder zero, and the hand of the dead-band test.
[[nodiscard]] std::vector<BuildParameter> build_parameters(const gap_case::Case& gap_case);

}  // namespace fusee::joint_model
