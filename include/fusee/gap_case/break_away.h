#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/csv.h"
#include "fusee/core/units.h"
#include "fusee/math/statistics.h"

/// Experiments on a real rig, and what they say about the model (docs/theory/identification.md).
namespace fusee::gap_case {

/// One break-away of a motor subsystem (paper, figures 7 and 8): motor torque held, the load at which the capstan starts to turn.
struct BreakAway {
    std::string side;           ///< "agonist" or "antagonist" or any other name of a motor
    bool backdrive = true;      ///< load raised until it drives the motor back; else (drive) lowered until the motor lifts it
    double motor_torque = 0.0;  ///< at the capstan before friction [Nm], >= 0
    double load_torque = 0.0;   ///< at the capstan [Nm], >= 0
    std::size_t line = 0;       ///< of its file; 0: from no file
    /// The friction met [Nm]: what the load is above the motor torque (backdrive) or below it (drive). Below 0 only by scatter or by a
    /// wrong direction.
    [[nodiscard]] double friction() const { return backdrive ? load_torque - motor_torque : motor_torque - load_torque; }
};

inline constexpr std::size_t kLargestBreakAwayFile = 200'000'000;  ///< bytes

/// Columns side, direction (drive or backdrive), motor_torque_Nm, load_torque_Nm in any order; other columns are ignored.
/// @param file the name used in messages
/// @throws core::InvalidInput "file:line:column: ...": as core::parse_csv; a torque that looks like mNm, unless the mapping gives its unit
[[nodiscard]] std::vector<BreakAway> parse_break_away(std::string_view csv, const std::string& file, const core::CsvMapping& mapping = {});

/// A straight line tau_f = constant + mu load with 95 % intervals (Student's t).
struct FrictionLine {
    std::string group;  ///< "all", "backdrive", "agonist", "agonist backdrive", ...
    std::size_t rows = 0;
    double mu = 0.0, constant = 0.0;
    core::Range mu_95, constant_95;
    double scatter = 0.0;  ///< standard deviation of the rows about the line [Nm]
    double r_squared = 0.0;
    double robust_mu = 0.0, robust_constant = 0.0;  ///< Huber's fit, robust against outliers
    std::vector<std::size_t> outliers;              ///< rows farther from the robust line than 4 robust deviations; of 8 rows or more
    double through_zero_mu = 0.0;                   ///< tau_f = mu load, no constant: the paper's figure 8
    core::Range through_zero_mu_95;
    math::LinearFit fit;  ///< of constant and mu, in this order: for the band
    /// 95 % interval of the line at a load [Nm].
    [[nodiscard]] core::Range friction_95(double load) const { return fit.interval_at({1.0, load}); }
};

/// A remark on the data, with its probability under pure chance where a test was made.
struct FrictionRemark {
    std::string id;    ///< "constant", "motor_torque", "one_way", "sides", "curvature", "scatter", "outliers", "wrong_way", "law"
    std::string text;  ///< one sentence
    double p = std::numeric_limits<double>::quiet_NaN();
};

struct FrictionReport {
    /// All rows; all rows without outliers if there are any; then each direction, side, and side with direction, of those that have
    /// at least 3 rows and two loads. A group that equals another one is left out.
    std::vector<FrictionLine> lines;
    bool outliers_left_out = false;  ///< lines[1] is all rows without outliers
    /// The line behind the law. @pre lines is not empty
    [[nodiscard]] const FrictionLine& trusted() const { return lines[outliers_left_out ? 1 : 0]; }
    std::vector<FrictionRemark> remarks;
    /// Repeats: rows with the same side, direction and motor torque; mean and standard deviation, figure 8's error bars.
    struct Repeat {
        std::string side;
        bool backdrive = true;
        double motor_torque = 0.0, mean_load = 0.0, mean_friction = 0.0;
        double deviation = 0.0;  ///< of the friction [Nm]; NaN for a single row
        std::size_t rows = 0;
    };
    std::vector<Repeat> repeats;
    /// Share of the scatter variance that grows with the friction squared: 0 all rows scatter equally, near 1 in proportion to friction.
    double scatter_growth = 0.0;

    /// A motor with both directions: its friction, and the torque that it gives over the stated one, distinguished by
    ///     scale tau_m = load + s (constant + mu load),  s = -1 backdrive, +1 drive          (docs/theory/identification.md, eq. 6)
    struct Motor {
        std::string side;
        std::size_t rows = 0;
        double scale = 1.0, mu = 0.0, constant = 0.0;  ///< [1], [1], [Nm]
        core::Range scale_95, mu_95, constant_95;
        double p = 1.0;  ///< chance of a scale as far from 1 if it is 1
        /// Is the scale not 1? Then the law counts the motor's torques times `scale`.
        bool differs = false;
    };
    std::vector<Motor> motors;
    /// A motor with one direction only: friction and an error of the torque constant give the same rows. Each reading explains all of it.
    struct OneWay {
        std::string side;
        bool backdrive = true;
        std::size_t rows = 0;
        double mu = 0.0;  ///< with the stated torques
        core::Range mu_95;
        double scale = 1.0;  ///< torque over the stated one, without friction
        core::Range scale_95;
        /// The rows that would tell: the load of the other direction at the greatest motor torque, in either reading [Nm].
        double motor_torque = 0.0, load_by_friction = 0.0, load_by_scale = 0.0;
    };
    std::vector<OneWay> one_way;

    /// A law for a profile: constant + mu load, constant 0 unless the data show one.
    struct Law {
        double mu = 0.0, constant = 0.0;
    };
    /// The law of the motors with both directions. It is missing if there is no such motor, or the data give no friction that
    /// spring::FrictionLaw allows.
    std::optional<Law> law;
    std::size_t law_rows = 0;  ///< number of rows that the law is from; 0: all of them
    /// The lines of a profile's table [rig], or "" without a law.
    [[nodiscard]] std::string profile_lines() const;
};

/// @throws core::InvalidInput with fewer than 3 rows, or if all loads are equal
[[nodiscard]] FrictionReport identify_friction(const std::vector<BreakAway>& rows);

/// A gear's friction as identified from one file of break-away tests.
struct Identification {
    std::string name;         ///< of the file, without its ending
    std::string file_sha256;  ///< of the CSV as read
    FrictionReport friction;
};

}  // namespace fusee::gap_case
