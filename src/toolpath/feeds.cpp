#include <fmt/format.h>

#include <cmath>

#include "fusee/core/units.h"
#include "fusee/toolpath/settings.h"
#include "gcode.h"

namespace fusee::toolpath {

namespace {

constexpr double kLeastChip_mm = 0.010;  // the radius of a carbide edge is 3 to 5 um; a chip of less than twice that is not cut (practice)

}  // namespace

const char* to_string(Stuff stuff) {
    switch (stuff) {
        case Stuff::kPlastic:
            return "plastic";
        case Stuff::kAluminium:
            return "aluminium";
        case Stuff::kBrass:
            return "brass";
        case Stuff::kSteel:
            return "steel";
    }
    return "";
}

double chip_load_mm(Stuff stuff, double diameter_mm) {
    switch (stuff) {
        case Stuff::kPlastic:
            return 0.036 / 3.0 * diameter_mm;
        case Stuff::kAluminium:
            return 0.025 / 3.0 * diameter_mm;
        case Stuff::kBrass:
            return 0.022 / 3.0 * diameter_mm;
        case Stuff::kSteel:
            return 0.013 / 3.0 * diameter_mm;
    }
    return 0.0;
}

double feed_of(const Settings& settings, double asked, double diameter_mm, double rpm) {
    if (asked > 0.0) return asked;
    return core::m_from_mm(chip_load_mm(settings.stuff, diameter_mm) * settings.flutes * rpm) / 60.0;
}

core::Finding judge_chip_load(const Settings& settings, double asked, double diameter_mm, double rpm, const char* key, const char* where) {
    const double feed = mm_per_min(feed_of(settings, asked, diameter_mm, rpm)), per_um = 1e3 / (settings.flutes * rpm);
    core::Finding f;
    f.rule = "toolpath.chip_load";
    f.what =
        fmt::format("the cutter of {:.3f} mm rubs: its chip load in {} at {:.0f} mm/min", diameter_mm, to_string(settings.stuff), feed);
    f.measured = feed * per_um;
    f.bound = core::Bound::kAtLeast;
    f.allowed = 1e3 * kLeastChip_mm;
    f.unit = "um";
    f.where = where;
    f.suggestion = core::change(key, fmt::format("{:.0f}", std::ceil(1e3 * kLeastChip_mm / per_um)));
    f.source = "docs/guides/milling.md: chip load";
    return core::judged(f, core::Severity::kWarning);
}

}  // namespace fusee::toolpath
