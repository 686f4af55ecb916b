#pragma once
#include <string>
#include <vector>

#include "fusee/assembly/motion.h"

namespace fusee::assembly {

/// The least distance of two bodies, or of a cable and a body, over the working range.
struct Gap {
    std::string a, b;        ///< names; the cable as "series cable, agonist"
    double mm = 0.0;         ///< least of all sampled poses; 0: they meet
    double proven_mm = 0.0;  ///< bodies: no pose of the working range has less; cables: 0, sampled only
    Pose pose;               ///< where it is least
};

/// The gap of each pair but those that are fixed to each other or touch by design (an axle in its bearing); of pairs that the mirror image
/// repeats one. Sampled: 33 poses of a motion, 13 x 13 of two, 7 of each of three, 5 of each of four; then proven over all poses, as far as
/// `enough_mm` or to 0.05 mm below the sampled distance; a `proven_mm` below both says that the proof was given up. Bodies are taken as
/// hulls of layers, which hold them. By rising distance; pairs that are proven or sampled to stay more than 10 mm apart are left out.
[[nodiscard]] std::vector<Gap> body_gaps(const Assembly& assembly, double enough_mm);
/// Is the distance proven as far as `enough_mm`, or to 0.05 mm below the sampled one?
[[nodiscard]] bool is_proven(const Gap& gap, double enough_mm);
/// The gaps of each cable's free lengths, from its surface, and the bodies that it does not touch.
[[nodiscard]] std::vector<Gap> cable_gaps(const Assembly& assembly);

}  // namespace fusee::assembly
