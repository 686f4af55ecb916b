#pragma once
#include <vector>

#include "fusee/joint_model/motion.h"

namespace fusee::joint_model {

/// Appends what the encoders of a rig read: theta_agonist, theta_antagonist behind backlash, q with its offset; generic terms of each.
inline void append_reading(const BuiltRig& rig, const Motion& motion, std::vector<double>& read) {
    for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist})
        read.push_back(motion.encoder(side) + rig.sides[static_cast<std::size_t>(side)].gear.terms.reading(motion.theta(side)));
    read.push_back(rig.read_q(motion.q(), motion.joint_torque()));
}

}  // namespace fusee::joint_model
