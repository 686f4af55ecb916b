#pragma once
#include <array>
#include <filesystem>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/design/algorithm_1.h"
#include "fusee/design/robust.h"
#include "fusee/spring/catalogue.h"

namespace fusee::design {

/// Search methods of `fusee design`.
enum class Method {
    kAlgorithm1,  ///< the paper's (k, u, C) by its Algorithm 1, springs alone
    kCoDesign,    ///< a law together with base springs, radius and lead-in, inside what can be made
    kPareto,      ///< the same for two objectives: a front of designs
};

/// Their names in profiles and on the command line, in the order of the enumeration.
inline constexpr std::array kMethodNames{"algorithm_1", "co_design", "pareto"};

/// Settings of every method.
struct SearchOptions {
    Method method = Method::kAlgorithm1;
    int population = 60;    ///< >= 8; of a Pareto front, a multiple of 4
    int generations = 300;  ///< >= 1
    int seed = 1;           ///< >= 0: the same seed gives the same result, bit for bit, on any number of threads
};

/// Which law is searched together with springs, preloads, radius and lead-in.
enum class SearchedLaw {
    kStiction,   ///< (k, u, C)
    kFreeCurve,  ///< S and T through knots: spring::make_free_curve
};

/// The objective over the dead-bands at several torques.
enum class DeadBandFigure {
    kMean,
    kWorst,
    kPercentile95,  ///< mean of the 95th percentiles over the shop's scatter (robust.h)
};

/// Second objective of a Pareto front, next to the dead-band.
enum class Against {
    kTravel,  ///< capstan travel, more is better
    kSize,    ///< largest contour radius of both cams, less is better
};

/// Whether the search avoids designs with warnings (review and accept).
enum class Reviews { kAvoid, kAccept };

/// Variables and constraints of `fusee design --method co_design` and `pareto` (docs/theory/co_design.md). A demand of 0 is replaced by
/// the figure of the profile's law: without demands on travel and stiffness, the least dead-band is that of a rigid joint.
struct CoDesignOptions {
    SearchedLaw law = SearchedLaw::kStiction;
    int knots = 6;  ///< of the free curve, evenly spaced in ln(load), 4 to 12

    DeadBandFigure figure = DeadBandFigure::kMean;
    ShopScatter scatter = {};          ///< of kPercentile95
    double covered_share = 0.95;       ///< of kPercentile95: least RobustBand::covered_share at each of `torques`; 0: no constraint
    std::vector<double> torques = {};  ///< co-contraction at which the exact dead-band counts [Nm]; empty: 6 from least to overdrive
    core::Range loads = {};            ///< travel is measured between these loads, stiffness at them [Nm]; 0 0: least to overdrive torque
    double travel = 0.0;               ///< least capstan travel between them [rad]
    double soft = 0.0;                 ///< joint stiffness with held capstans at the lower one: at most this [Nm/rad]
    double stiff = 0.0;                ///< and at the upper one: at least this [Nm/rad]

    // Sources of these limits: docs/theory/co_design.md. The limits of the rules also apply.
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
