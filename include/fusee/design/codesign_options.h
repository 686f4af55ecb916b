#pragma once
#include <filesystem>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/design/robust.h"
#include "fusee/spring/catalogue.h"

namespace fusee::design {

/// Which law is searched together with springs, preloads, radius and lead-in.
enum class SearchedLaw {
    kStiction,   ///< (k, u, C)
    kFreeCurve,  ///< S and T through knots: spring::make_free_curve
};

/// How the dead-bands at several torques become one figure.
enum class DeadBandFigure {
    kMean,
    kWorst,
    kPercentile95,  ///< mean of the 95th percentiles over the shop's scatter (robust.h)
};

/// What a Pareto front sets against the dead-band.
enum class Against {
    kTravel,  ///< capstan travel, more is better
    kSize,    ///< largest contour radius of both cams, less is better
};

/// What a rule's "review and accept" means to the search.
enum class Reviews { kAvoid, kAccept };

/// What `fusee design --method co_design` and `pareto` search and hold to (docs/theory/co_design.md). A demand that is 0 is taken from the
/// profile's own law: without travel and stiffness demanded, the least dead-band is that of a rigid joint.
struct CoDesignOptions {
    SearchedLaw law = SearchedLaw::kStiction;
    int knots = 6;  ///< of the free curve, evenly spaced in ln(load), 4 to 12

    DeadBandFigure figure = DeadBandFigure::kMean;
    ShopScatter scatter = {};          ///< of kPercentile95
    double covered_share = 0.95;       ///< of kPercentile95: least RobustBand::covered_share at each of `torques`; 0: not asked for
    std::vector<double> torques = {};  ///< co-contraction at which the exact dead-band counts [Nm]; empty: 6 from least to overdrive
    core::Range loads = {};            ///< between these loads travel is measured, at them stiffness [Nm]; 0 0: least to overdrive torque
    double travel = 0.0;               ///< least capstan travel between them [rad]
    double soft = 0.0;                 ///< joint stiffness with held capstans at the lower one: at most this [Nm/rad]
    double stiff = 0.0;                ///< and at the upper one: at least this [Nm/rad]

    // docs/theory/co_design.md tells where the limits come from; the rules' own hold besides.
    double contour_radius = 40e-3;  ///< of both cams' working arcs at most, cable centreline [m]
    double least_rho_se = 5e-3;     ///< least radius of curvature of K_SE's working arc [m]
    double least_rho_pe = 4e-3;     ///< of K_PE's [m]
    Reviews reviews = Reviews::kAvoid;

    core::Range capstan_radius = {};            ///< r_c [m]; 0 0: the profile's. r_j/r_c stays
    core::Range lead_in = {0.0, 0.5};           ///< [rad]
    core::Range winding = {0.5, 8.0};           ///< preload of the torsion spring [rad]
    core::Range compression = {0, 0.02};        ///< preload of the compression spring [m]
    double span = 6.0;                          ///< rates and stiffnesses are searched from 1/span to span times the profile's
    std::filesystem::path catalogue_file = {};  ///< as written in the profile; empty: any rate
    spring::Catalogue catalogue = {};

    Against against = Against::kTravel;  ///< of the Pareto front
};

}  // namespace fusee::design
