#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fusee/gap_case/break_away.h"
#include "fusee/gap_case/files.h"

/// A gap case: nominal rig and measurements (docs/gap.md). Everything is SI; angles and torques are those of the capstan unless
/// the name says joint; a capstan's angle and torque are positive when they wind its own cable in.
namespace fusee::gap_case {

enum class Side : int { kAgonist = 0, kAntagonist = 1 };
[[nodiscard]] const char* to_string(Side side);  ///< "agonist", "antagonist"

/// The nominal rig: table [rig] of case.toml.
struct NominalRig {
    double capstan_radius = 0.0;       ///< r_c [m]
    double joint_radius = 0.0;         ///< r_j [m]
    double gear_load_friction = 0.0;   ///< mu
    double motor_inertia = 0.0;        ///< of each motor, at the capstan [kg m^2]
    double joint_inertia = 0.0;        ///< [kg m^2]
    double motor_viscous = 0.0;        ///< at the capstan [Nms/rad]
    double joint_viscous = 0.0;        ///< [Nms/rad]
    double se_torsion_rate = 0.0;      ///< k_t of K_SE's base spring, at the spool [Nm/rad]
    double pe_compression_rate = 0.0;  ///< k of K_PE's base spring [N/m]
    struct SpringRow {
        double deflection = 0.0, se_torque = 0.0, pe_torque = 0.0;
    };
    std::vector<SpringRow> springs;                                               ///< both sides equal, deflection ascending from 0
    [[nodiscard]] double ratio() const { return joint_radius / capstan_radius; }  ///< g
    static constexpr std::size_t kSpringSteps = 2400;  ///< of a spring curve: places at which it is looked at and integrated
    /// @throws core::InvalidInput naming the deflection if a curve does not rise there
    void require_rising_springs() const;
};

/// Build tolerances of the nominal values, one sigma: a gap within them is not an effect. Table [tolerance].
struct Tolerance {
    double gear_load_friction = 0.02;           ///< relative
    double radii = 0.003;                       ///< r_c and r_j, relative
    double inertia = 0.03;                      ///< relative
    double spring_rate = 0.008;                 ///< relative
    double se_radius = 3e-5, pe_radius = 2e-5;  ///< [m]
    double se_preload = 0.005;                  ///< [rad of spool]
    double pe_preload = 5e-5;                   ///< [m]
    double torque_scale = 0.005;                ///< relative
    double joint_coulomb = 0.005;               ///< [Nm]
    double joint_offset = 0.003;                ///< [rad]
};

/// Table [sensors].
struct Sensors {
    double encoder_step = 7.67e-4;         ///< [rad]
    double encoder_noise = 6e-4;           ///< one sigma [rad]
    double torque_noise_relative = 0.003;  ///< one sigma
    double torque_noise = 1.5e-3;          ///< one sigma [Nm]
    double breakaway_scatter = 0.03;       ///< one sigma, relative, of the friction from one break-away to the next
    double log_rate = 100.0;               ///< [Hz]
};

/// How long each phase took [s]. Table [protocol].
struct Protocol {
    double motor_ramp = 0.6, motor_settle = 0.4;
    bool smooth_motor_ramp = false;  ///< 3 s^2 - 2 s^3 instead of a straight line: the rest position of a gear depends on it
    double dead_band_push = 1.6, dead_band_release = 3.15;
    double joint_stiffness_phase = 2.0, cocontraction_phase = 5.0;
};

struct SpringPull {
    bool series = true;  ///< K_SE, else K_PE
    Side side = Side::kAgonist;
    bool load = true;  ///< else unload
    double deflection = 0.0, torque = 0.0;
};
struct DeadBandRow {
    static constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();
    double cocontraction = 0.0;
    int repeat = 1;
    double push_torque = kNotGiven;                ///< NaN: not given, a strong push
    double q_low = kNotGiven, q_high = kNotGiven;  ///< NaN where the table has only the width
    double width = kNotGiven;                      ///< q_high - q_low
    std::size_t row = 0;  ///< of its table, from 1, of the last one where this row stands for its repeats too; 0: it stands for itself
};
enum class StiffnessPhase : int { kLoadUp, kUnloadUp, kLoadDown, kUnloadDown };  ///< load+, unload+, load-, unload-
struct StiffnessRow {
    double cocontraction = 0.0;
    StiffnessPhase phase = StiffnessPhase::kLoadUp;
    double joint_torque = 0.0, q = 0.0;
    std::size_t row = 0;  ///< of its file, from 1, so that rows that were left out keep their time; 0: none was
};
struct CocontractionRow {
    bool up = true;
    double motor_torque = 0.0, theta_agonist = 0.0, theta_antagonist = 0.0, q = 0.0;
};
struct LogRow {
    double time = 0.0, torque_agonist = 0.0, torque_antagonist = 0.0, joint_torque = 0.0;
    double theta_agonist = 0.0, theta_antagonist = 0.0, q = 0.0;
};

enum class Experiment : int { kBreakAway, kSpringPull, kDeadBand, kJointStiffness, kCocontraction, kLog };
inline constexpr std::size_t kExperiments = 6;
inline constexpr double kLongestLog = 60.0;                  ///< of a log, from its first row [s]: each fit simulates it again
inline constexpr std::size_t kLongestTable = 20'000;         ///< rows used of a file; of longer ones every n-th row
inline constexpr std::size_t kMostRows = 12'000'000;         ///< rows read of a file
inline constexpr std::size_t kLargestTable = 1'500'000'000;  ///< bytes of a file
inline constexpr std::array<Experiment, kExperiments> kAllExperiments{Experiment::kBreakAway,     Experiment::kSpringPull,
                                                                      Experiment::kDeadBand,      Experiment::kJointStiffness,
                                                                      Experiment::kCocontraction, Experiment::kLog};
[[nodiscard]] const char* to_string(Experiment experiment);  ///< "breakaway", "spring_pull", "dead_band", "joint_stiffness", ...

/// The rows of every experiment of a case; empty where the case has none. Without measurements the measured values are NaN.
struct Rows {
    std::vector<BreakAway> breakaway;
    std::vector<SpringPull> spring_pull;
    std::vector<DeadBandRow> dead_band;
    bool dead_band_width_only = false;
    std::vector<StiffnessRow> joint_stiffness;
    std::vector<CocontractionRow> cocontraction;
    std::vector<LogRow> log;
    /// Number of rows of each file, in the order of the file names; 0: missing file. Empty: all rows are of the first file.
    std::map<Experiment, std::vector<std::size_t>> parts;
    [[nodiscard]] std::size_t size(Experiment experiment) const;
    [[nodiscard]] std::size_t size() const;
};

/// How a column of a lab's file stands for one of the format. Table [columns.EXPERIMENT].
struct ColumnMap {
    std::string header;                 ///< its name in the file
    std::optional<double> factor = {};  ///< from the number in the file to the format's unit; none: from the unit in the header
};
/// The maps of each experiment, by the format's column name.
using ColumnMaps = std::map<Experiment, std::map<std::string, ColumnMap>>;

struct Case {
    std::string name;    ///< of its folder
    std::string sha256;  ///< over every file of it that was read
    NominalRig rig;
    Tolerance tolerance;
    Sensors sensors;
    Protocol protocol;
    std::map<Experiment, std::vector<std::string>> files;  ///< as named in [experiments]
    ColumnMaps columns;                                    ///< of files with other column names or units
    Rows rows;
    std::vector<std::string> remarks;  ///< limitations: few rows, thinned log, a table with defaults
};

/// Reads DIR/case.toml and the CSV files that it names. Implausible values (a mu of 22, a radius of 15: another unit) are
/// rejected with the required unit. Of a log longer than `kLongestLog` only the beginning is used; a file above `kLongestTable` rows is
/// thinned; a remark says so. A row without a number in a measured column is left out, and a remark counts them.
/// @throws core::InvalidInput "file:line:column: key", core::IoError
[[nodiscard]] Case read_case(const std::filesystem::path& folder);
/// The same from a folder or from memory. @throws as read_case
[[nodiscard]] Case read_case(const CaseFiles& files);
/// The same without the rows of the experiments: for a prediction. Measured cells may be empty. @throws as read_case
[[nodiscard]] Case read_nominal(const std::filesystem::path& folder);
/// What DIR/case.toml describes: [rig], a whole joint; [bench], an element of one (fusee/subsystem/subsystem.h); [model], whatever a
/// simulator of the user's own does (fusee/simulator/case.h).
enum class CaseKind : int { kJoint, kElement, kSimulator };
/// @throws as read_case if it cannot be read or is no TOML
[[nodiscard]] CaseKind kind_of_case(const std::filesystem::path& folder);

/// The input columns of the experiment files in `folder` with the file names of the case; measured columns may be missing or have
/// empty cells: such values are NaN. Nothing is thinned. @throws as read_case, and if none of the files exists
[[nodiscard]] Rows read_inputs(const Case& nominal, const std::filesystem::path& folder);
/// The same from a folder or from memory. @throws as read_inputs
[[nodiscard]] Rows read_inputs(const Case& nominal, const CaseFiles& files);
/// Writes the files that read_inputs reads, measured columns as in `rows`; NaN as an empty cell. Creates folders;
/// keeps other files. @throws core::IoError
void write_rows(const Case& nominal, const Rows& rows, const std::filesystem::path& folder);
/// The same files as texts.
[[nodiscard]] CaseTexts row_texts(const Case& nominal, const Rows& rows);

/// One column of an experiment's file: numbers, or words such as "agonist".
struct Column {
    std::string name;  ///< "q_low_rad"
    std::variant<std::vector<double>, std::vector<std::string>> cells;
};
/// The columns of an experiment's rows, named and ordered as in its file; none if there are no rows. Missing numbers are NaN.
[[nodiscard]] std::vector<Column> columns_of(const Rows& rows, Experiment experiment);

}  // namespace fusee::gap_case
