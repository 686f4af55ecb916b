#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/units.h"
#include "fusee/design/budget.h"

namespace fusee::pipeline {

struct ResolvedDesign;
struct PartReport;
struct Simulation;

/// The arms of one part as its process makes it.
struct MadeArm {
    std::string part;           ///< "k_pe"
    double tolerance_mm = 0.0;  ///< of the process's contour, one side
    double least_arm_mm = 0.0;  ///< over the working range
    /// Largest relative error of an arm: the tolerance at the least arm.
    [[nodiscard]] double worst_relative() const { return tolerance_mm / least_arm_mm; }
};

/// The dead-band at one co-contraction: full width at the joint.
struct ExpectedWidth {
    double tau = 0.0;                                           ///< [Nm]
    double nominal = std::numeric_limits<double>::quiet_NaN();  ///< exact, of the law as designed [rad]; NaN: not covered
    core::Range built{nominal, nominal};                        ///< 5 to 95 % of joints as a shop builds them [rad]
};

/// A single spring over its law.
struct SpringFigures {
    core::Range angles;                                             ///< [rad]
    core::Range torques;                                            ///< least and greatest, signed [Nm]
    double built_error = std::numeric_limits<double>::quiet_NaN();  ///< 5 to 95 % of springs as built are within +- this share of the
                                                                    ///< largest torque; NaN: the part was not made
};

/// The figures that a summary of a design begins with.
struct Headline {
    std::string process;                           ///< "fdm"; empty: nothing is known
    std::vector<MadeArm> arms;                     ///< of K_SE, of K_PE; none where an arm is 0 or changes its sign
    std::optional<SpringFigures> spring;           ///< of a profile of one spring, for which the figures below are unknown
    std::optional<design::budget::Budget> budget;  ///< none with a roller cam: it is not modelled
    ExpectedWidth least, overdrive;                ///< dead-band at the ends of the co-contractions in use
    double joint_torque = std::numeric_limits<double>::quiet_NaN();  ///< greatest at which every spring stays inside its law [Nm]
    actuator::ConditionSummary condition;                            ///< the paper's (6)
};

/// @param simulation of the same design; none of a single spring, which has neither dead-band nor budget @param parts K_SE's and K_PE's
/// @param draws joints sampled for the budget; 0: first order only
[[nodiscard]] Headline headline_of(const ResolvedDesign& design, const std::optional<Simulation>& simulation,
                                   const std::vector<PartReport>& parts, int draws = 0);

/// How far the exported files are from the law; NaN: none was read back.
struct FileErrors {
    double arm = std::numeric_limits<double>::quiet_NaN();        ///< largest relative error of an arm
    double dead_band = std::numeric_limits<double>::quiet_NaN();  ///< largest relative change of a dead-band
};

/// Slopes d(T tau_f)/dtau within +-this are too small to be built, a hundredth of the arm error allowed in a file: stiction stays the same.
inline constexpr double kSlightestSlope = 1e-5;
/// Verdict on condition (6), d(T tau_f)/dtau < 0.
enum class ConditionVerdict { kHolds, kFails, kMixed, kWithinRounding, kNotKnown };
[[nodiscard]] ConditionVerdict condition_verdict(const actuator::ConditionSummary& condition);
[[nodiscard]] const char* to_string(ConditionVerdict verdict);  ///< "holds", "fails", "holds in part", "within rounding", "not known"

}  // namespace fusee::pipeline
