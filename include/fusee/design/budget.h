#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fusee/actuator/joint.h"
#include "fusee/cam/cam.h"
#include "fusee/spring/base_spring.h"

/// Error budget of a joint, or of a single spring, as a shop builds it: how far the torque of each spring and the dead-band are from the
/// design, and which tolerance causes it (docs/theory/budget.md). Equation numbers there.
namespace fusee::design::budget {

/// Options of the profile's table [budget]: limits to both sides that the process does not state, two standard deviations each.
struct BudgetOptions {
    double runout = 0.0;                       ///< of a cam's axis on its shaft [m]; 0: half of the bore's clearance
    double guide = 0.3e-3;                     ///< of a hole or idler, across its cable; of a follower's line, sideways [m]
    double direction = 8.7266462599716477e-3;  ///< of a parallel exit [rad]
    double rate = 0.1;                         ///< of a base spring whose rate is nominal
    double measured_rate = 0.02;               ///< of one whose rate was measured
    double preload = 0.02;                     ///< of the base spring's state at the law's lowest load
    double cable = 0.05;                       ///< of the cable's diameter
    double zero = 8.7266462599716477e-3;       ///< of the capstan's angle against the cams [rad]
    double friction = 0.2;                     ///< of a gear
};

/// Names where an error comes from.
enum class Source : std::size_t {
    kContour,   ///< the contour is larger or smaller all along
    kRunout,    ///< the cam's axis is beside the shaft's
    kGuide,     ///< the guide or the follower's line is beside its place; of a parallel exit: its direction is off
    kRate,      ///< rate of the base spring
    kPreload,   ///< state of the base spring at the law's lowest load
    kCable,     ///< cable diameter: half of its error is an error of each arm
    kZero,      ///< zero of the capstan's angle against the cams: timing marks, knots, encoder
    kFriction,  ///< of a gear: only the dead-band depends on it
};
inline constexpr std::size_t kSources = 8;
[[nodiscard]] const char* to_string(Source source);  ///< "contour"

/// Limits, each to both sides: two standard deviations of a normal error, as +-10 % of a spring's maker. All >= 0.
struct Tolerances {
    double contour = 0.1e-3;    ///< [m]
    double runout = 0.1e-3;     ///< of the axis in each of two directions [m]
    double guide = 0.3e-3;      ///< [m]
    double direction = 8.7e-3;  ///< of a parallel exit [rad]
    double rate = 0.1;          ///< relative
    double preload = 0.02;      ///< relative
    double cable = 0.05;        ///< of its diameter, relative
    double zero = 8.7e-3;       ///< [rad]
    double friction = 0.2;      ///< relative
    /// The limit of one source, in its own unit. @param parallel the guide is a parallel exit
    [[nodiscard]] double of(Source source, bool parallel) const;
};

/// One cam with its base spring and the tolerances of its process.
struct PartSubject {
    const cam::Cam* cam = nullptr;
    spring::BaseSpring spring;
    cam::Allowance allowance;
    Tolerances tolerances;
};

/// The joint: K_SE, K_PE, equal on both sides.
struct Subject {
    actuator::Actuator actuator;
    std::array<PartSubject, 2> parts;
};

/// Error of a spring's torque at one travel of the capstan: relative; of a single spring a share of its largest torque, as the torque may
/// cross 0.
struct TorqueError {
    double travel = 0.0;                   ///< of the capstan since the law's lowest load [rad]
    double torque = 0.0;                   ///< as designed [Nm]
    std::array<double, kSources> sigma{};  ///< standard deviation by each source alone, first order (eq. 1 to 4)
    [[nodiscard]] double whole() const;    ///< of all sources: root of the sum of squares
    core::Range band;                      ///< 5 and 95 %, first order
    core::Range sampled{0.0, 0.0};         ///< 5 and 95 % of the sampled joints
};

struct PartBudget {
    cam::PartKind kind = cam::PartKind::kSeries;
    std::string name;                                ///< of its table: "k_se", "k_pe", "cam"
    bool parallel = false;                           ///< the guide is a parallel exit: its limit is an angle
    std::array<double, kSources> limits{};           ///< tolerances of its sources, each in its own unit
    std::vector<TorqueError> places;                 ///< from the lowest to the greatest travel
    [[nodiscard]] const TorqueError& worst() const;  ///< the place with the widest first-order band
};

/// The dead-band at one co-contraction: full width at the joint [rad].
struct WidthBudget {
    double tau = 0.0;      ///< [Nm]
    double nominal = 0.0;  ///< NaN, like all below: the springs do not cover it
    std::array<double, kSources> sigma{};
    double whole = 0.0;   ///< sigma of all sources
    core::Range band;     ///< 5 and 95 %, first order; the logarithm of the width is taken as normal
    core::Range sampled;  ///< 5 and 95 % of the sampled joints
};

struct Budget {
    std::vector<PartBudget> parts;    ///< K_SE, K_PE; or the one of a single spring
    std::vector<WidthBudget> widths;  ///< one for each torque
    int draws = 0;                    ///< joints sampled; 0: none
};

struct SampleOptions {
    int draws = 200;         ///< 0, or at least 20
    std::uint64_t seed = 1;  ///< of the counter-based streams, one for each joint
    unsigned jobs = 0;       ///< threads; 0: one for each processor; no influence on the result
};

/// First order and Monte Carlo over the whole geometry: each sampled cam is shifted, grown and led by a shifted guide, its tangents are
/// found anew, its spring is the inverse of the arms, both sides of the joint are coupled.
/// @pre both cams are on cables @throws InvalidInput naming a tolerance below 0, or draws
[[nodiscard]] Budget budget_of(const Subject& subject, std::span<const double> torques, const SampleOptions& options = {});

/// The budget of a single spring, on a cable or a roller, to first order: one part, no dead-band (docs/theory/budget.md, eq. 2, 3, 5); or
/// of two cables, one each way (eq. 6). @param subjects one, or both: the travel of the second counts down, both have as many working rows
/// @param name of the part's table @throws InvalidInput naming a tolerance below 0
[[nodiscard]] Budget budget_of_spring(std::span<const PartSubject> subjects, double capstan_radius, const std::string& name);

/// Tolerance of one source for a wanted band, in the source's own unit.
struct Needed {
    Source source = Source::kContour;
    double stated = 0.0;
    double alone = 0.0;   ///< if every other source were perfect
    double shared = 0.0;  ///< if all sources that matter contribute equally
};
/// Finds the tolerances for which the 5 to 95 % band of the torque is within +-`wanted` (relative) at every place, by the first order.
/// Sources without influence, or with a tolerance of 0, are left out.
[[nodiscard]] std::vector<Needed> tolerances_for_torque(const PartBudget& part, double wanted);

/// Half of a 5 to 95 % band of a normal error, in standard deviations.
inline constexpr double kPercentile = 1.6448536269514722;

}  // namespace fusee::design::budget
