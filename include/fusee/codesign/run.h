#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/output_folder.h"
#include "fusee/core/progress.h"
#include "fusee/profile/profile.h"

namespace fusee::codesign {

/// How a search is run; what it looks for stands in the profile ([design] and the method's own table).
struct RunOptions {
    std::filesystem::path out = "out";  ///< the result lands in out/NAME-design as a whole, the checkpoint beside it
    unsigned jobs = 0;                  ///< threads; 0 = one for each processor; no influence on the result
    bool resume = false;                ///< go on from the checkpoint
    bool force = false;                 ///< begin anew over a search that was stopped; and as core::OutputRun has it
    std::function<void(int generation, double best)> progress = {};
    std::function<bool()> stop = core::interrupted;
};

/// What became of a search.
struct RunResult {
    bool found = false;                ///< there is a design, and it is written
    bool interrupted = false;          ///< stopped early: the best so far
    std::filesystem::path folder;      ///< empty when nothing was written
    core::Findings findings;           ///< not found: what binds; found: what else has to be known (reviews)
    std::vector<std::string> summary;  ///< lines for a terminal
};

/// out/NAME-design, and the checkpoint beside it.
[[nodiscard]] std::filesystem::path result_folder(const profile::Profile& profile, const RunOptions& options);
[[nodiscard]] std::filesystem::path checkpoint_file(const profile::Profile& profile, const RunOptions& options);

/// The run that writes result_folder.
[[nodiscard]] core::OutputRun output_run(const profile::Profile& profile, const RunOptions& options);

/// A profile that was read from one folder, to be written into `folder`: the files that it names are reached from there.
[[nodiscard]] profile::Profile moved(profile::Profile profile, const std::filesystem::path& folder);

}  // namespace fusee::codesign
