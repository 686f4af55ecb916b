#include "fusee/toolpath/settings.h"

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "gcode.h"

namespace fusee::toolpath {

namespace {

constexpr double kLeastChip_mm = 0.010;  // the radius of a carbide edge is 3 to 5 um; a chip of less than twice that is not cut (practice)

}  // namespace

void require_valid(const Settings& s) {
    using core::mm_from_m;
    const auto positive = [](const char* key, double value, const char* unit) {
        core::require_positive(std::string("machining.") + key, value, unit);
    };
    positive("tool_diameter_mm", mm_from_m(s.tool_diameter), "mm");
    core::require_within("machining.feed_mm_per_min", mm_per_min(s.feed), 0.0, 1e5, "mm/min");
    core::require_within("machining.plunge_feed_mm_per_min", mm_per_min(s.plunge_feed), 0.0, 1e5, "mm/min");
    positive("spindle_rpm", s.spindle_rpm, "1/min");
    positive("depth_per_pass_mm", mm_from_m(s.depth_per_pass), "mm");
    positive("terrace_mm", mm_from_m(s.terrace), "mm");
    core::require_within("machining.wrap_feed_mm_per_min", mm_per_min(s.wrap_feed), 0.0, 1e5, "mm/min");
    positive("wrap_rpm", s.wrap_rpm, "1/min");
    positive("wrap_depth_mm", mm_from_m(s.wrap_depth), "mm");
    positive("safe_height_mm", mm_from_m(s.safe_height), "mm");
    core::require_within("machining.breakthrough_mm", mm_from_m(s.breakthrough), 0.0, 1000.0, "mm");
    positive("tolerance_mm", mm_from_m(s.tolerance), "mm");
    positive("flute_length_mm", mm_from_m(s.flute_length), "mm");
    positive("stick_out_mm", mm_from_m(s.stick_out), "mm");
    positive("holder_diameter_mm", mm_from_m(s.holder_diameter), "mm");
    positive("chuck_diameter_mm", mm_from_m(s.chuck_diameter), "mm");
    positive("chuck_grip_mm", mm_from_m(s.chuck_grip), "mm");
    positive("tab_width_mm", mm_from_m(s.tab_width), "mm");
    positive("tab_height_mm", mm_from_m(s.tab_height), "mm");
    for (const auto& [key, rpm] : {std::pair{"machining.spindle_rpm", s.spindle_rpm}, std::pair{"machining.wrap_rpm", s.wrap_rpm}})
        core::require_within(key, rpm, 1.0, s.spindle_max_rpm, "1/min");
    if (s.rotary_sign != 1 && s.rotary_sign != -1)
        throw core::InvalidInput("machining.rotary_sign", fmt::format("{}", s.rotary_sign), "1 or -1");
}

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
