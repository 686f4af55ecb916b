#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "fusee/joint_model/motion.h"

namespace fusee::joint_model {

/// Encoder readings of a rig: motors with gear backlash, joint with its offset; generic terms of both.
class Reading {
public:
    explicit Reading(const BuiltRig& rig) : rig_(rig) {}
    /// Appends theta_agonist, theta_antagonist, q.
    void append(const Motion& motion, std::vector<double>& read) {
        for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist}) {
            const auto i = static_cast<std::size_t>(side);
            const double theta = motion.theta(side), half = 0.5 * rig_.sides[i].gear.backlash;
            read_[i] = std::clamp(read_[i], theta - half, theta + half);
            read.push_back(read_[i] + rig_.sides[i].gear.terms.reading(theta));
        }
        read.push_back(rig_.read_q(motion.q(), motion.joint_torque()));
    }

private:
    const BuiltRig& rig_;
    std::array<double, 2> read_{};
};

}  // namespace fusee::joint_model
