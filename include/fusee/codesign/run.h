#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fusee/codesign/pareto_report.h"
#include "fusee/codesign/search_report.h"
#include "fusee/core/finding.h"
#include "fusee/core/output_folder.h"
#include "fusee/core/progress.h"
#include "fusee/profile/profile.h"

namespace fusee::codesign {

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

}  // namespace fusee::codesign
