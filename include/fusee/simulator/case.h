#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/gap_case/files.h"

/// A simulator of the user's own as a model of the engine (docs/guides/my-simulator-does-not-match.md): its case, the process that
/// answers for it, and the port effects that every model has.
namespace fusee::simulator {

/// The columns of one run by name, all of one length.
using Columns = std::map<std::string, std::vector<double>>;

/// One file of an experiment; it is held out as a whole.
struct Run {
    std::string file;
    Columns columns;  ///< inputs, and outputs as measured
    [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.begin()->second.size(); }
};

/// The unit in a column's or a parameter's name: "voltage_V", "rate_N_per_m". "1": a pure number, or a unit that nobody knows.
[[nodiscard]] std::string unit_in(const std::string& name);

/// A measured column.
struct Output {
    std::string name, unit;
    double sigma = 1.0;  ///< standard deviation of its noise, in its unit
};

struct Experiment {
    std::string name;
    std::vector<std::string> inputs;
    std::vector<Output> outputs;
    std::vector<Run> runs;
    /// The input that is a time: t_s; "": none.
    [[nodiscard]] std::string time() const;
};

/// A figure of the simulator.
struct Parameter {
    std::string name, unit;
    double nominal = 0.0;
    double sigma = 0.0;     ///< tolerance, one sigma, in its unit; 0: it stays nominal
    bool relative = false;  ///< the tolerance was stated as a share of the nominal value
};

/// A cause that the user names: parameters that it frees.
struct Effect {
    std::string id;
    std::vector<std::size_t> frees;   ///< places in Case::parameters; the first gives the size, value - nominal
    std::vector<double> usual;        ///< of each: size of the first, value of the others
    std::vector<core::Range> ranges;  ///< of the value of each
    std::string meaning, remedy;
};

struct Case {
    std::string name;    ///< of its folder
    std::string sha256;  ///< over every file of it that was read
    std::filesystem::path folder;
    std::filesystem::path model;       ///< the file with [model], [parameters] and [effects]; the process works in its folder
    std::vector<std::string> command;  ///< of the process; empty for a case from memory
    std::chrono::milliseconds timeout{60'000};
    std::vector<Experiment> experiments;
    std::vector<Parameter> parameters;
    std::vector<Effect> effects;
    std::vector<std::string> remarks;  ///< limitations: estimated noise, one run
};

/// Reads FOLDER/case.toml and the CSV files that it names.
/// @param model a file whose [model], [parameters] and [effects] stand in place of the case's own; "": these
/// @throws core::InvalidInput "file:line:column: key", core::IoError
[[nodiscard]] Case read_case(const std::filesystem::path& folder, const std::filesystem::path& model = {});
/// The same from a folder or from memory, where [model] needs no command. @throws as read_case
[[nodiscard]] Case read_case(const gap_case::CaseFiles& files, bool needs_command, const std::filesystem::path& model = {});

/// Refuses another model: other parameters or effects, by name, unit and what they free. Nominal values, logs and programs may differ.
/// @throws core::InvalidInput naming the folder of `other`
void require_same_model(const Case& own, const Case& other);

/// The runs of the case whose files are in `folder`, with their input columns alone.
/// @throws as read_case, and if none of the files exists
[[nodiscard]] std::vector<Experiment> read_inputs(const Case& of_case, const std::filesystem::path& folder);
/// Writes one CSV file for each run, under its name. @throws core::IoError
void write_runs(const std::vector<Experiment>& experiments, const std::filesystem::path& folder);

/// Standard deviation of the noise of a smooth signal from its third differences; at least what its steps leave. NaN with fewer than 16
/// values. @param runs that are differenced each by itself
[[nodiscard]] double estimated_noise(const std::vector<const std::vector<double>*>& runs);
/// The stated noise, or the one that the rows show where that is clearly more.
[[nodiscard]] double measured_noise(const std::vector<const std::vector<double>*>& runs, double stated);

}  // namespace fusee::simulator
