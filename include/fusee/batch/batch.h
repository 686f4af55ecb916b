#pragma once
#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/pipeline/make.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::batch {

enum class Outcome {
    kMade,
    kRefused,         ///< an impossible design: `result.findings` name the binding limits
    kBadInput,        ///< `error` names the value, its place and the values allowed
    kOutOfResources,  ///< no value is wrong: a full disk, no memory, no thread: `error`
    kFailed,          ///< internal error: `error`
    kInterrupted,     ///< stopped by the user, before or while it was made
};
[[nodiscard]] const char* to_string(Outcome outcome);

/// The outcome for one profile.
struct Ended {
    std::filesystem::path profile;
    Outcome outcome = Outcome::kInterrupted;
    std::string error;
    std::vector<core::InvalidInput> mistakes;  ///< the wrong values, where `error` names values
    double seconds = 0.0;
};

/// Where designs go.
struct OutFolder {
    std::filesystem::path out = "out";  ///< a design is written to out/NAME, complete or not at all
    bool force = false;                 ///< also replace another profile's files in out/NAME, and files changed since (core::OutputRun)
};
inline constexpr std::size_t kStages = pipeline::kStages + 1;

/// A stage of the work on one profile.
struct Stage {
    std::string name;
    double seconds = 0.0;
};

/// The outcome of `make` for one profile.
struct MakeResult {
    std::string name;
    bool made = false;             ///< out/NAME is complete, and every file carries the law
    std::filesystem::path folder;  ///< empty when nothing was written
    core::Findings findings;       ///< all of them, passes too; a refusal holds the binding limits
    pipeline::Headline headline;
    pipeline::FileErrors file_errors;
    double dead_band_peak_deg = 0.0;             ///< exact, full width at the joint, at peak torque; 0 of a single spring
    std::vector<Stage> stages;                   ///< in turn; those of a refused design end at the refusal
    std::optional<pipeline::MadeDesign> design;  ///< with its parts, once its files are in place; none from make_all
};

/// One profile in, out/NAME out: part files, simulation and reports. A design that cannot be made writes nothing.
/// @param options their `stage` is called kStages times, the last time for the reports
/// @throws core::InvalidInput; core::IoError, also if out/NAME may not be written (core::OutputFolder)
[[nodiscard]] MakeResult make(const profile::Profile& profile, const OutFolder& folder = {}, const pipeline::MakeOptions& options = {});

/// One row of the closing table of `make`.
struct Row : Ended {
    MakeResult result;
};

/// One profile simulated.
struct SimulationRow : Ended {
    std::optional<pipeline::Simulation> simulation;
    std::filesystem::path folder;  ///< where its files are
    std::filesystem::path mjcf;    ///< where its model for MuJoCo is; empty: not asked for
    core::Findings refusal;        ///< why there is none, or why it lacks an equilibrium that was asked for
};

/// Makes every profile, `jobs` at a time (0: one for each processor); a failure is one row. Rows have the order of the profiles for any
/// number of jobs. Ctrl-C finishes the running profiles and starts no other. Shows progress for several profiles. Two profiles with one
/// name would write one folder: the later one is a kBadInput row. @param frame false: without, whatever the profile says
[[nodiscard]] std::vector<Row> make_all(const std::vector<std::filesystem::path>& profiles, const OutFolder& folder, unsigned jobs,
                                        pipeline::Via via = pipeline::Via::kCgal, bool frame = true);

/// Simulates every profile in the same manner and writes its files into out/NAME; other files there stay. If one of the paper's relatives
/// is among them, also writes their comparison, out/relatives.csv. @param force as OutFolder::force
/// @param mjcf not empty: the model of each joint for MuJoCo goes to mjcf/NAME
/// @throws core::IoError if the comparison cannot be written
[[nodiscard]] std::vector<SimulationRow> simulate_all(const std::vector<std::filesystem::path>& profiles, const std::filesystem::path& out,
                                                      const pipeline::SimulateOptions& options, unsigned jobs, bool force = false,
                                                      const std::filesystem::path& mjcf = {});

/// 0 made, 1 refused, 2 bad input, 3 internal error, 130 interrupted.
[[nodiscard]] int exit_code(Outcome outcome);
/// The gravest of all rows counts.
template <class AnyRow>
[[nodiscard]] int exit_code(const std::vector<AnyRow>& rows) {
    int gravest = 0;
    for (const Ended& row : rows) gravest = std::max(gravest, exit_code(row.outcome));
    return gravest;
}

/// The closing table, one line a row, and below it the binding findings of each design that was not made.
[[nodiscard]] std::string closing_table(const std::vector<Row>& rows);
/// Each simulation in short; the binding findings of those that were refused; a table that compares several.
[[nodiscard]] std::string closing_table(const std::vector<SimulationRow>& rows);

struct WatchOptions {
    OutFolder folder;
    std::function<void(const std::string& text)> say;          ///< one or a few lines, without the last line end
    std::function<void(const std::string& verdict)> answered;  ///< after each fast answer: its first line; may be empty
    std::function<void(const std::filesystem::path&)> made;    ///< after each finished make: out/NAME; may be empty
    std::function<bool()> stop;                                ///< asked 20 times a second
};

/// Watches a profile and the CSV files that it names. At the start and after each save: first the verdict of law, contours and rules
/// without a solid, then the full make in the background, which a newer save or a bad profile stops. Returns when `stop` says so, with no
/// make running; a stopped make leaves no file. @throws core::IoError if the profile does not exist or its folder cannot be watched
void watch_profile(const std::filesystem::path& profile, const WatchOptions& options);

}  // namespace fusee::batch
