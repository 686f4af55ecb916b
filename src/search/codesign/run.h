#pragma once
#include <string>
#include <vector>

#include "codesign/problem.h"
#include "fusee/core/units.h"
#include "fusee/design/evolution.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"
#include "fusee/search/design.h"
#include "fusee/search/design_report.h"

namespace fusee::search::codesign {

/// The evolution that [design] of the profile asks for, over a box; without a checkpoint and silent.
[[nodiscard]] design::EvolutionOptions evolution_of(const profile::Profile& profile, std::vector<core::Range> bounds,
                                                    const RunOptions& run);

/// Lets it tell its progress and, unless the run has no folder, keep its checkpoint next to the result folder. @param problem all that the
/// cost depends on: a checkpoint of another problem is refused
void keep_checkpoint(design::EvolutionOptions& options, const profile::Profile& profile, const RunOptions& run, std::string problem);

/// The springs of a joint's law, and its dead-band over the co-contraction `torques`.
[[nodiscard]] LawCurves law_curves(const actuator::Actuator& joint, core::Range torques);

/// One cam of a design, made as a solid; without a part if findings forbid it.
[[nodiscard]] CamCurve cam_curve(cam::PartKind kind, const pipeline::ResolvedDesign& design);

/// Enters the course of the search into its report.
void note_search(SearchReport& report, const profile::Profile& profile, const design::EvolutionResult& found);

/// What bounds a feasible design: its limits within 1 % of being broken, without those that no searched number moves.
[[nodiscard]] std::vector<Limit> binding(const Trial& trial);

}  // namespace fusee::search::codesign
