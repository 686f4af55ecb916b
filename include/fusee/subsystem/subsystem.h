#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fusee/core/csv.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/diagnosis/diagnosis.h"

/// Subsystem cases: one subsystem alone (docs/subsystem-cases.md). A folder with case.toml, where [bench] stands in place of [rig], and CSV
/// files. The nominal law's parameters are fitted on the case's own rows; an effect counts only if it also predicts whole files that its
/// fit has not seen.
namespace fusee::subsystem {

enum class Kind : int {
    kFrictionElement,  ///< a friction element driven by displacement: Coulomb
    kServoPendulum,    ///< a position servo that swings a mass: Coulomb and viscous friction, kt, R, inertia, angle offset
    kMotorBreakaway,   ///< break-away of a motor with its gear: friction in proportion to the load
    kCamJoint,         ///< a joint whose torque comes from a cam, turned by a dynamometer: the law of its file
};
[[nodiscard]] const char* to_string(Kind kind);  ///< "friction_element", "servo_pendulum", "motor_breakaway", "cam_joint"

/// Nominal torque of a joint over its angle, as designed; straight between rows. Empty: the kind has none.
struct LawCurve {
    std::string file;
    std::vector<double> q_rad, torque_Nm;  ///< angles ascending
};

/// One file of an experiment.
struct Record {
    std::string experiment;                                 ///< "force_loop", "pendulum_log", "breakaway", "pull"
    std::string file;                                       ///< as [experiments] names it
    std::map<std::string, double> parameters;               ///< "kp", "preload_N", ...: [bench], overridden by the words of the file
    std::map<std::string, std::string> words;               ///< non-numeric words of its '#' lines, e.g. "trajectory"
    std::map<std::string, std::vector<double>> columns;     ///< by name, all of one length; a measured column may be absent in inputs
    std::map<std::string, std::vector<std::string>> texts;  ///< "side", "direction"
    LawCurve law = {};                                      ///< of the cam in a pull
    [[nodiscard]] std::size_t rows() const;
};

struct Case {
    std::string name;    ///< of its folder
    std::string sha256;  ///< over every file of it that was read
    Kind kind = Kind::kFrictionElement;
    std::map<std::string, double> parameters;  ///< numbers of [bench], for every file
    std::map<std::string, std::string> words;  ///< texts of [bench], for every file: "goals", "motor"
    std::map<std::string, double> sensors;     ///< table [sensors]
    core::CsvMapping columns;                  ///< table [columns]: headers of the files
    std::vector<Record> records;               ///< in the order of their files' names
    std::vector<std::string> remarks;          ///< limitations: thinned rows, few files
};

/// Reads FOLDER/case.toml and the CSV files that it names.
/// @throws core::InvalidInput "file:line:column: key", core::IoError
[[nodiscard]] Case read_case(const std::filesystem::path& folder);

/// Finds where nominal law and measurements differ, which effects survive every split of the files, how far the gap shrinks on held-out
/// files. Deterministic for any number of threads. @throws core::InvalidInput if there are too few rows
[[nodiscard]] diagnosis::Diagnosis diagnose(const Case& subsystem_case, const diagnosis::DiagnoseOptions& options = {});

/// Every CSV file in `folder`; measured columns may be missing. A file's parameters are those of [bench], those of the case's file of the
/// same name over them, and the words of its own '#' lines over all. A CSV file of a law is no input: a pull takes its law from the file
/// that its word names, from law_X.csv for pull_X.csv, or from the case. @throws as read_case; core::IoError if there is no CSV file
[[nodiscard]] Case read_inputs(const Case& subsystem_case, const std::filesystem::path& folder);
/// `inputs` with the measured column as the law says, row by row: with `found.build` and `found.effects`; without `found.build` the
/// nominal parameters are fitted on the rows of `subsystem_case` first, the effects held. The zero of a file that the case does not have
/// is the mean of the case's.
/// @throws core::InvalidInput naming an unknown effect
[[nodiscard]] Case predict(const Case& subsystem_case, const diagnosis::Diagnosis& found, const Case& inputs);
/// Writes one CSV for each record, under its file name: the columns of the subsystem.
/// @throws core::IoError
void write_rows(const Case& rows, const std::filesystem::path& folder);

}  // namespace fusee::subsystem
