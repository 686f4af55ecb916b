#include "leg.h"

#include "spring_change.h"

namespace fusee::checks {

double leg_bend_radius(const spring::BaseSpring& s) { return s.leg_bend_radius > 0.0 ? s.leg_bend_radius : s.wire_diameter; }

double leg_force(const Design& design) { return design.spring.rate * largest_state(design) / design.part.options.features.leg_slot_radius; }

}  // namespace fusee::checks
