#include "flanges.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/sweep.h"

namespace fusee::exchange {

FlangeReach flange_reach(const solid::Part& part) {
    const solid::Flanges flanges = solid::flanges_of(part.options);
    return {part.section.front().offset_mm, flanges.lower_height_mm, flanges.upper_height_mm, flanges.core_radius_mm};
}

std::vector<std::array<double, 2>> upper_outline(const solid::Part& part) {
    const FlangeReach reach = flange_reach(part);
    const double radius = part.cam.closed() ? 0.0 : helix_radius_mm(part);
    std::vector<std::array<double, 2>> outline;
    for (const double psi : part.columns_psi) {
        if (part.cam.closed())
            outline.push_back(solid::flange_point(part.cam.path(psi), reach.lip + reach.upper, 0.0).point);
        else
            outline.push_back({radius * std::cos(psi), radius * std::sin(psi)});
    }
    return outline;
}

double helix_radius_mm(const solid::Part& part) {
    double radius = 0.0;
    for (const solid::Vec3& p : part.skin.points_mm) radius = std::max(radius, std::hypot(p[0], p[1]));
    return radius;
}

}  // namespace fusee::exchange
