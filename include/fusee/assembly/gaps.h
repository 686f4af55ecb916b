#pragma once
#include <string>
#include <vector>

#include "fusee/assembly/motion.h"

namespace fusee::assembly {

/// The least distance of two bodies, or of a cable and a body, over the working range.
struct Gap {
    std::string a, b;  ///< names; the cable as "series cable, agonist"
    double mm = 0.0;   ///< 0: they meet
    Pose pose;         ///< where it is least
};

/// Of each pair but those that are fixed to each other or touch by design (an axle in its bearing); of pairs that the mirror image repeats
/// one. Sampled: 33 poses of a motion, 13 x 13 of two, 7 of each of three, 5 of each of four. Bodies are taken as hulls of layers,
/// so that a gap is never overrated between the samples' poses. By rising distance; pairs that stay more than 10 mm apart are left out.
[[nodiscard]] std::vector<Gap> body_gaps(const Assembly& assembly);
/// Of each cable's free lengths, from its surface, and the bodies that it does not touch.
[[nodiscard]] std::vector<Gap> cable_gaps(const Assembly& assembly);

}  // namespace fusee::assembly
