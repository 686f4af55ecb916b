#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"
#include "fusee/profile/profile.h"
#include "fusee/search/design_report.h"

namespace fusee::search::codesign {

/// How a search is run; its target is in the profile ([design] and the method's own table).
struct RunOptions {
    std::filesystem::path out = "out";  ///< the result folder is out/NAME-design; the checkpoint is next to it
    unsigned jobs = 0;                  ///< threads; 0 = one for each processor; no influence on the result
    bool resume = false;                ///< continue from the checkpoint
    bool force = false;                 ///< start again over a search that was stopped; and as core::OutputRun has it
    std::function<void(int generation, double best)> progress = {};
    std::function<bool()> stop = core::interrupted;
};

/// A profile that a search found, to be written.
struct FoundProfile {
    std::filesystem::path file;  ///< in the result folder: "NAME-best.toml", "pareto/03.toml"
    std::string toml;
};

/// The outcome of a search.
struct RunResult {
    bool interrupted = false;               ///< stopped early: the best so far
    core::Findings findings;                ///< not found: the limits that bind; found: what else has to be known
    std::vector<std::string> summary = {};  ///< lines for a terminal
    std::optional<SearchReport> search;     ///< of Algorithm 1 and co-design
    std::optional<ParetoReport> pareto;     ///< of a Pareto front
    std::vector<FoundProfile> profiles = {};
    [[nodiscard]] bool found() const { return search || pareto; }
};

/// out/NAME-design, and the checkpoint next to it.
[[nodiscard]] std::filesystem::path result_folder(const profile::Profile& profile, const RunOptions& options);
[[nodiscard]] std::filesystem::path checkpoint_file(const profile::Profile& profile, const RunOptions& options);

/// The run that writes the result folder.
[[nodiscard]] core::OutputRun output_run(const profile::Profile& profile, const RunOptions& options);

/// A profile that was read from one folder, to be written into `folder`: the files that it names are reached from there.
[[nodiscard]] profile::Profile moved(profile::Profile profile, const std::filesystem::path& folder);

/// Algorithm 1 on the profile's rig, from the law's start torque to the motors' peak torque, for springs that exist up to the law's end
/// torque. The profile found is NAME-best.toml: the profile with the law found. The checkpoint is written next to the result folder, or not
/// at all if `options.out` is empty.
/// The result is "not found" ("design.feasible", with a change) if no (k, u, C) in the box is a pair of springs, or none of those costs
/// less than the border where the springs vanish. Whether the law found can be cut into cams on the profile's base springs is judged and
/// reported, not required.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult run_algorithm_1(const profile::Profile& profile, const RunOptions& options);

/// Searches law, base springs, radius and lead-in together for the least exact dead-band that [co_design] allows; makes the best with its
/// solids and every rule, in a temporary folder. The profile found is NAME-best.toml.
/// If nothing is found, the result has the limits that the best candidate breaks, or the findings that refused its solids.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult run_co_design(const profile::Profile& profile, const RunOptions& options);

/// The front of designs that trade the exact dead-band against capstan travel or size ([co_design] against), by NSGA-II. Against travel the
/// front begins at a quarter of the travel demanded. Every point is made with its solids, rules and files; a point that cannot be made is
/// dropped and counted. The profiles found are pareto/NN.toml. A stop ends the search with the front so far.
/// If nothing is found, the result has the limits that the nearest candidate breaks.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult run_pareto(const profile::Profile& profile, const RunOptions& options);

/// Values of one call that replace those of [design].
struct SearchChanges {
    std::optional<std::string> method = {};  ///< one of design::kMethodNames
    std::optional<int> population = {}, generations = {}, seed = {};
};

/// @throws InvalidInput for a method that has another name
void change_search(design::SearchOptions& search, const SearchChanges& changes);

/// Searches springs by the method of the profile's [design]: run_algorithm_1, run_co_design or run_pareto.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult find_springs(const profile::Profile& profile, const RunOptions& options);

}  // namespace fusee::search::codesign
