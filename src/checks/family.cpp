#include "family.h"

namespace fusee::checks {

bool suits(const Rule& rule, const Design& design) {
    const cam::Family family = design.part.cam.has_roller() ? cam::Family::kRoller : cam::Family::kCable;
    return !rule.family || rule.family == family;
}

Cable cable_on(const Design& design) {
    Cable cable = design.cable;
    if (design.part.cam.has_roller()) cable.diameter = 0.0;
    return cable;
}

}  // namespace fusee::checks
