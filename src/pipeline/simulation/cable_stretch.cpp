#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulate.h"

namespace fusee::pipeline {

std::vector<StretchSide> stretch_sides(const ResolvedDesign& design) {
    std::vector<StretchSide> sides;
    if (!design.profile.has_parts) return sides;
    for (const cam::PartKind kind : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const cam::ArmPoint most = design.arm(kind).at_load(design.law()->loads().high);
        if (most.elongation.turn != 0.0) sides.push_back({kind, most});
    }
    return sides;
}

}  // namespace fusee::pipeline
