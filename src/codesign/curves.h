#pragma once
#include "fusee/core/units.h"
#include "fusee/design/evolution.h"
#include "fusee/profile/profile.h"
#include "fusee/report/search.h"

namespace fusee::codesign {

/// A law's springs and its dead-band over the co-contraction `torques` of the profile's joint.
[[nodiscard]] report::LawCurves law_curves(const profile::Profile& profile, const spring::SpringLawPtr& law, core::Range torques);

/// One cam of a profile, made as a solid; what forbids it is a finding and leaves the part out.
[[nodiscard]] report::CamCurve cam_curve(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law);

/// How the search for a profile went, as the report tells it.
void note_search(report::SearchReport& report, const profile::Profile& profile, const design::EvolutionResult& found);

}  // namespace fusee::codesign
