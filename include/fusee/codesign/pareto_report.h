#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "fusee/core/provenance.h"
#include "fusee/core/units.h"

/// A front of designs (docs/guides/co-design.md).
namespace fusee::codesign {

/// One design of the front.
struct ParetoPoint {
    std::string file;               ///< its profile, "pareto/03.toml"
    double figure = 0.0;            ///< the dead-band that was minimised [rad]
    std::vector<double> dead_band;  ///< exact, full width at the joint, at ParetoReport::torques [rad]
    double travel = 0.0;            ///< of the capstan [rad]
    core::Range stiffness;          ///< of the joint, capstans held [Nm/rad]
    double radius = 0.0;            ///< largest contour radius of both cams [m]
    double capstan_radius = 0.0;    ///< [m]
    std::string limited_by;         ///< the limits that bind, in words
};

struct ParetoReport {
    core::Provenance provenance;
    bool against_size = false;            ///< else against travel
    std::vector<double> torques;          ///< [Nm]
    core::Range loads;                    ///< between which travel, at which stiffness is measured [Nm]
    std::vector<ParetoPoint> points;      ///< by rising figure
    std::size_t dropped = 0;              ///< points of the front that could not be made
    std::vector<std::string> dropped_by;  ///< the rules that forbade them
    std::size_t evaluations = 0;
    int population = 0, generations = 0, seed = 0;
    bool interrupted = false;
};

}  // namespace fusee::codesign
