#include "fusee/spring/base_spring.h"

#include <cmath>

#include "fusee/math/interval.h"

namespace fusee::spring {

// rate/2 (state^2 - preload^2) = energy
double BaseSpring::state(double energy) const { return std::sqrt(preload * preload + 2.0 * energy / rate); }
math::Jet BaseSpring::state(const math::Jet& energy) const { return sqrt(preload * preload + 2.0 * energy / rate); }

BaseSpring in_series_with_cable(BaseSpring base, double compliance) {
    const double longer = 1.0 + base.rate * compliance;  // exactly 1 for compliance 0
    base.rate /= longer;
    base.preload *= longer;
    return base;
}

}  // namespace fusee::spring
