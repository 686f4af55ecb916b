#include "fusee/spring/base_spring.h"

#include <cmath>

#include "fusee/math/interval.h"

namespace fusee::spring {

// rate/2 (state^2 - preload^2) = energy
double BaseSpring::state(double energy) const { return std::sqrt(preload * preload + 2.0 * energy / rate); }
math::Jet BaseSpring::state(const math::Jet& energy) const { return sqrt(preload * preload + 2.0 * energy / rate); }

}  // namespace fusee::spring
