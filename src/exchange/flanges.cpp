#include "flanges.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/outline.h"

namespace fusee::exchange {

namespace {
constexpr double kBossRim_mm = 1.0;  // as solid::build_part: the lower flange reaches this far beyond a boss
constexpr double kProud_mm = 0.3;    // as solid::sweep: a flange widened by a boss stands at least this far beyond the lips
}  // namespace

FlangeReach flange_reach(const solid::Part& part) {
    const bool boss = part.options.hub.boss_height > 0.0;
    FlangeReach reach;
    reach.lip = part.section.front().offset_mm;
    reach.upper = core::mm_from_m(part.options.flange_height);
    reach.lower = boss ? std::max(reach.upper, kProud_mm) : reach.upper;
    reach.core_radius = boss ? core::mm_from_m(0.5 * part.options.hub.boss_diameter) + kBossRim_mm : 0.0;
    return reach;
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
