#pragma once
#include <limits>
#include <string>
#include <vector>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/units.h"

namespace fusee::report {

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

/// What the user gets of a design, with its range: what a summary begins with.
struct Outlook {
    std::string process;                                             ///< "fdm"; empty: nothing is known
    std::vector<MadeArm> arms;                                       ///< of K_SE, of K_PE
    ExpectedWidth least, overdrive;                                  ///< dead-band at the ends of the co-contractions in use
    double joint_torque = std::numeric_limits<double>::quiet_NaN();  ///< greatest that no spring leaves its law for [Nm]
    actuator::ConditionSummary condition;                            ///< the paper's (6)
};

/// One figure of a summary: "75.5 to 20.4 deg", and what it is of.
struct HeadFigure {
    std::string value, label;
};
/// How far the exported files are from the law; NaN: none was read back.
struct FileErrors {
    double arm = std::numeric_limits<double>::quiet_NaN();        ///< largest relative error of an arm
    double dead_band = std::numeric_limits<double>::quiet_NaN();  ///< largest relative change of a dead-band
};
/// What the user gets, by importance: dead-band over the co-contractions, arms of the parts as made, joint torque, condition (6).
[[nodiscard]] std::vector<HeadFigure> head_figures(const Outlook& outlook, const FileErrors& files);

/// How condition (6), d(T tau_f)/dtau < 0, ends. Slopes of less than 1e-5 either way are too small to be built: stiction stays the same.
enum class ConditionVerdict { kHolds, kFails, kMixed, kWithinRounding, kNotKnown };
[[nodiscard]] ConditionVerdict condition_verdict(const actuator::ConditionSummary& condition);
[[nodiscard]] const char* to_string(ConditionVerdict verdict);  ///< "holds", "fails", "holds in part", "within rounding", "not known"
/// "Condition (6) holds from 0.85 Nm to 1.5 Nm, by 0.012 at least: ..."
[[nodiscard]] std::string condition_text(const actuator::ConditionSummary& condition);

}  // namespace fusee::report
