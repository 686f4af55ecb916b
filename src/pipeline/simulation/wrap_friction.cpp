#include "fusee/cam/wrap_friction.h"

#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::pipeline {

std::vector<WrapSide> wrap_sides(const ResolvedDesign& design) {
    std::vector<WrapSide> sides;
    const cam::WrapFriction& wrap = design.profile.wrap;
    if (!design.profile.has_parts || wrap.friction <= 0.0 || wrap.stiffness <= 0.0) return sides;
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const auto cam = design_cam(kind, design);
        if (!cam || cam->has_roller()) continue;  // `make` says why there is no cam
        const profile::PartSpec& spec = design.spec(kind);
        const double rate = spring::in_series_with_cable(spec.spring, spec.allowance.cable_compliance).rate;
        sides.push_back({kind, cam::wrap_loop(*cam, rate, design.profile.rig.capstan_radius, wrap)});
    }
    return sides;
}

}  // namespace fusee::pipeline
