#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fusee/actuator/dead_band.h"
#include "fusee/cam/arm.h"
#include "fusee/core/finding.h"
#include "fusee/core/provenance.h"
#include "fusee/core/units.h"
#include "fusee/solid/part.h"
#include "fusee/spring/law.h"

/// The design that a search found (docs/guides/design-springs.md).
namespace fusee::search::codesign {

/// A searched number and its value in the design found.
struct SearchedVariable {
    std::string name, unit;
    core::Range box;
    double found = 0.0;
    double own = std::numeric_limits<double>::quiet_NaN();  ///< of the profile's own law; NaN: it has none
};

/// A figure of the design found, and the same figure of the profile's own design.
struct ComparedFigure {
    std::string name, unit;
    double found = 0.0, own = std::numeric_limits<double>::quiet_NaN();
};

/// One picture of the paper's figure 9: the cost over one variable.
struct CostCurve {
    std::string variable, unit;
    std::vector<double> value, cost;              ///< the other variables at the optimum
    std::vector<bool> feasible;                   ///< false: of the first stage
    std::vector<double> candidates, lowest_cost;  ///< of all candidates, by parts of the box; NaN: none there
    double optimum = 0.0;
};

/// The springs of one design.
struct LawCurves {
    std::vector<spring::LawPoint> samples;      ///< by rising load
    std::vector<actuator::DeadBand> dead_band;  ///< by rising co-contraction
};

/// One cam of the design found.
struct CamCurve {
    cam::PartKind kind = cam::PartKind::kSeries;
    std::vector<cam::ArmPoint> arms;  ///< arms that the law needs on the profile's base spring
    std::optional<solid::Part> part;  ///< none: it cannot be cut, and `findings` say why
    core::Findings findings;
};

struct SearchReport {
    core::Provenance provenance;
    std::string method;  ///< "algorithm_1", ...
    int population = 0, generations = 0, seed = 0;
    std::size_t evaluations = 0;
    bool interrupted = false;
    double cost = 0.0;
    std::vector<SearchedVariable> variables;
    std::vector<ComparedFigure> figures;
    std::vector<double> history;  ///< best cost of the first population and after each generation
    std::vector<CostCurve> costs;
    LawCurves found, own;
    std::vector<CamCurve> cams;
    core::Findings findings;           ///< of the law found
    std::vector<std::string> remarks;  ///< sentences
};

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

}  // namespace fusee::search::codesign
