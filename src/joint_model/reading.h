#pragma once
#include <array>
#include <vector>

#include "fusee/joint_model/motion.h"

namespace fusee::joint_model {

/// The predicted values of each rig.
template <class V>
using ReadingsOf = std::array<std::vector<double>, kWidth<V>>;

/// Appends what the joint's encoder of each rig reads now.
template <class V>
void append_q(const MotionOf<V>& motion, ReadingsOf<V>& read) {
    for (std::size_t i = 0; i < read.size(); ++i)
        read[i].push_back(motion.rigs()[i]->read_q(lane(motion.q(), i), lane(motion.joint_torque(), i), lane(motion.session(), i)));
}
/// Appends what the encoders read: theta_agonist, theta_antagonist behind backlash, q with its offset; generic terms of each.
template <class V>
void append_reading(const MotionOf<V>& motion, ReadingsOf<V>& read) {
    for (const gap_case::Side side : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist})
        for (std::size_t i = 0; i < read.size(); ++i) {
            const Ripple& reading = motion.rigs()[i]->sides[static_cast<std::size_t>(side)].gear.terms.reading;
            read[i].push_back(lane(motion.encoder(side), i) + (reading.is_on() ? reading(lane(motion.theta(side), i)) : 0.0));
        }
    append_q(motion, read);
}

}  // namespace fusee::joint_model
