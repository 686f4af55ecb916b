#pragma once
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fusee/pipeline/make.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::batch {

enum class Outcome {
    kMade,
    kRefused,      ///< an impossible design: `result.findings` name the binding limits
    kBadInput,     ///< `error` says what, where and what is allowed
    kFailed,       ///< anything else that went wrong inside: `error`
    kInterrupted,  ///< not begun: the user asked to stop
};
[[nodiscard]] const char* to_string(Outcome outcome);

/// How one profile ended.
struct Ended {
    std::filesystem::path profile;
    Outcome outcome = Outcome::kInterrupted;
    std::string error;
    double seconds = 0.0;
};

/// One row of the closing table of `make`.
struct Row : Ended {
    pipeline::MakeResult result;
};

/// One profile simulated.
struct SimulationRow : Ended {
    std::optional<report::Simulation> simulation;
    std::filesystem::path folder;  ///< where its files are
    core::Findings refusal;        ///< why there is none, or why it lacks an equilibrium that was asked for
};

/// Files as given, whether they exist or not (a missing one becomes a row); a folder stands for its *.toml files, by name.
/// @throws IoError if a folder holds none or cannot be read
[[nodiscard]] std::vector<std::filesystem::path> find_profiles(const std::vector<std::filesystem::path>& paths);

/// Makes every profile on its own, `jobs` at a time (0: one for each processor); one failure is one row. Rows come in the profiles' order,
/// whatever the number of jobs. Ctrl-C lets what is begun finish and begins nothing new. Shows progress when there is more than one. Two
/// profiles with one name would write one folder: the later one is a kBadInput row.
[[nodiscard]] std::vector<Row> make_all(const std::vector<std::filesystem::path>& profiles, const pipeline::MakeOptions& options,
                                        unsigned jobs);

/// Simulates every profile in the same manner and writes its files into out/NAME; what else lies there stays. With one of the paper's
/// relatives among them, also their comparison, out/relatives.csv.
/// @throws core::IoError if the comparison cannot be written
[[nodiscard]] std::vector<SimulationRow> simulate_all(const std::vector<std::filesystem::path>& profiles, const std::filesystem::path& out,
                                                      const pipeline::SimulateOptions& options, unsigned jobs);

/// 0 made, 1 refused, 2 bad input, 3 a failure inside, 130 interrupted.
[[nodiscard]] int exit_code(Outcome outcome);
/// The gravest of all rows counts.
template <class AnyRow>
[[nodiscard]] int exit_code(const std::vector<AnyRow>& rows) {
    int gravest = 0;
    for (const Ended& row : rows) gravest = std::max(gravest, exit_code(row.outcome));
    return gravest;
}

/// The closing table, one line a row, and under it what binds each design that was not made.
[[nodiscard]] std::string closing_table(const std::vector<Row>& rows);
/// Each simulation in short; what binds those that were refused; with more than one a table that compares them.
[[nodiscard]] std::string closing_table(const std::vector<SimulationRow>& rows);

}  // namespace fusee::batch
