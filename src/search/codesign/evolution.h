#pragma once
#include <string>
#include <vector>

#include "fusee/design/evolution.h"
#include "fusee/search/design.h"

namespace fusee::search::codesign {

/// The evolution that [design] of the profile asks for, over a box; without a checkpoint and silent.
[[nodiscard]] design::EvolutionOptions evolution_of(const profile::Profile& profile, std::vector<core::Range> bounds,
                                                    const RunOptions& run);

/// Lets it tell its progress and, unless the run has no folder, keep its checkpoint next to the result folder. @param problem all that the
/// cost depends on: a checkpoint of another problem is refused
void keep_checkpoint(design::EvolutionOptions& options, const profile::Profile& profile, const RunOptions& run, std::string problem);

}  // namespace fusee::search::codesign
