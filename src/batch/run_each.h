#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "fusee/batch/batch.h"
#include "fusee/core/progress.h"

namespace fusee::batch {

/// Work on the profile that stands at `place` of the list: true if done, false if refused.
using Work = std::function<bool(const profile::Profile& profile, std::size_t place)>;

/// Reads every profile, then works on each on its own, `jobs` at a time (0: one for each processor), and advances `progress`, if any. An
/// exception of `work` becomes its row's outcome. In the profiles' order.
[[nodiscard]] std::vector<Ended> run_each(const std::vector<std::filesystem::path>& profiles, const Work& work, unsigned jobs,
                                          core::Progress* progress);

/// The rows with the outcome of each.
template <class AnyRow>
std::vector<AnyRow> joined(std::vector<AnyRow> rows, const std::vector<Ended>& ended) {
    for (std::size_t i = 0; i < rows.size(); ++i) static_cast<Ended&>(rows[i]) = ended[i];
    return rows;
}

}  // namespace fusee::batch
