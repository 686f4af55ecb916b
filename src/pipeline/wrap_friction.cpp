#include "fusee/cam/wrap_friction.h"

#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::pipeline {

std::vector<report::WrapSide> wrap_sides(const profile::Profile& profile, const spring::SpringLawPtr& law) {
    std::vector<report::WrapSide> sides;
    if (!profile.has_parts || profile.wrap.friction <= 0.0 || profile.wrap.stiffness <= 0.0) return sides;
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const auto cam = design_cam(kind, profile, law);
        if (!cam || cam->has_roller()) continue;  // `make` says why there is no cam
        const profile::PartSpec& spec = spec_of(kind, profile);
        const double rate = spring::in_series_with_cable(spec.spring, spec.allowance.cable_compliance).rate;
        sides.push_back({kind, cam::wrap_loop(*cam, rate, profile.rig.capstan_radius, profile.wrap)});
    }
    return sides;
}

}  // namespace fusee::pipeline
