#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kNarrow = 35.0, kWide = 45.0, kWithFleet = 60.0;  // [deg]
constexpr double kSmallFleet = 1.5;                                // [deg]

core::Findings measure_groove_throat(const Design& design, const Allowed& allowed) {
    if (is_stacked(design)) return {};  // plates have square edges
    double fleet = 0.0;
    for (const cam::Contact& c : design.part.cam.working)
        fleet = std::max(fleet, deg_from_rad(std::abs(fleet_from_groove(design.part.cam, c))));
    const bool fleeted = fleet > kSmallFleet;
    const double overhang = process_limits(design.process).overhang;
    // A printer that cannot build a rope throat (process.overhang) needs a wider one, which is accepted.
    const double printed = design.process.kind == ProcessKind::kFdm ? 180.0 - 2.0 * deg_from_rad(overhang) : 0.0;
    const double low = fleeted ? kWithFleet : kNarrow, high = std::max(fleeted ? kWithFleet : kWide, printed);
    const double throat = deg_from_rad(design.part.options.groove.throat);
    core::Finding f = compare(throat, {allowed("low_review", low), allowed("high_review", high)});
    f.what = fmt::format("throat angle of the groove at {:.1f} deg fleet", fleet);
    if (printed > kWithFleet) f.what += fmt::format("; a rope throat is 35 to 60 deg, printing without supports needs {:.0f}", printed);
    f.suggestion = change("groove.throat_deg", number(std::max(f.allowed, printed)));
    return {f};
}

}  // namespace

Rule groove_throat() {
    return {"groove.throat",
            "flanks that guide the cable badly or rub on it",
            "throat angle",
            "Unirope/Python: 35-45 deg, 60 above 1.5 deg fleet",
            {review(kAtLeast, "deg", "35 deg, 60 above 1.5 deg of fleet", "low_review"),
             review(kAtMost, "deg", "45 deg, 60 above 1.5 deg of fleet; FDM: 180 deg - 2 overhang if larger", "high_review")},
            measure_groove_throat};
}

}  // namespace fusee::checks
