#include <fmt/format.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/solid/part.h"

namespace fusee::solid {

std::vector<SectionPoint> groove_section(const GrooveOptions& groove, double cable_diameter, double chordal_error) {
    const double d = core::require_positive("cable.diameter_mm", core::mm_from_m(cable_diameter), "mm");
    const double tolerance = core::require_within("tolerances.chordal_error_mm", core::mm_from_m(chordal_error), 1e-5, 1.0, "mm");
    const double radius = d * core::require_within("groove.radius_ratio", groove.radius_ratio, 0.5, 2.0);
    const double half_throat =
        0.5 * core::rad_from_deg(core::require_within("groove.throat_deg", core::deg_from_rad(groove.throat), 0.0, 150.0 + 1e-9, "deg"));
    const double sweep = core::kPi / 2.0 - half_throat;  // half angle of the arc, which meets the flanks tangentially
    const double arc_depth = radius * (1.0 - std::cos(sweep));
    const double depth = d * core::require_within("groove.depth_ratio", groove.depth_ratio, arc_depth / d + 1e-6, 10.0, "cable diameters");

    const double step = 2.0 * std::acos(1.0 - std::min(tolerance / radius, 1.0));
    const int half = std::max(2, static_cast<int>(std::ceil(sweep / step)));
    const double lip = radius * std::sin(sweep) + (depth - arc_depth) * std::tan(half_throat);
    std::vector<SectionPoint> section{{depth - d / 2.0, -lip}};
    for (int i = -half; i <= half; ++i) {
        const double angle = sweep * i / half;
        section.push_back({radius * (1.0 - std::cos(angle)) - d / 2.0, radius * std::sin(angle)});
    }
    section.push_back({depth - d / 2.0, lip});
    return section;
}

std::vector<SectionPoint> rim_section(const PartOptions& options) {
    const double half = 0.5 * core::mm_from_m(options.rim_width) - core::mm_from_m(options.groove.rib);
    if (!(half > 0.0))
        throw core::InvalidInput("k_pe.roller.rim_width_mm", fmt::format("{} mm", core::mm_from_m(options.rim_width)),
                                 fmt::format("above two ribs, {:g} mm", 2.0 * core::mm_from_m(options.groove.rib)));
    return {{0.0, -half}, {0.0, 0.0}, {0.0, half}};
}

}  // namespace fusee::solid
