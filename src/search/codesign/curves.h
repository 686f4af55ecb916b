#pragma once
#include "fusee/core/units.h"
#include "fusee/design/evolution.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"
#include "fusee/search/design_report.h"

namespace fusee::search::codesign {

/// The springs of a joint's law, and its dead-band over the co-contraction `torques`.
[[nodiscard]] LawCurves law_curves(const actuator::Actuator& joint, core::Range torques);

/// One cam of a design, made as a solid; without a part if findings forbid it.
[[nodiscard]] CamCurve cam_curve(cam::PartKind kind, const pipeline::ResolvedDesign& design);

/// Enters the course of the search into its report.
void note_search(SearchReport& report, const profile::Profile& profile, const design::EvolutionResult& found);

}  // namespace fusee::search::codesign
