#include "fusee/toolpath/settings.h"

#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "gcode.h"

namespace fusee::toolpath {

void require_valid(const Settings& s) {
    using core::mm_from_m;
    const auto positive = [](const char* key, double value, const char* unit) {
        core::require_positive(std::string("machining.") + key, value, unit);
    };
    positive("tool_diameter_mm", mm_from_m(s.tool_diameter), "mm");
    positive("feed_mm_per_min", mm_per_min(s.feed), "mm/min");
    positive("plunge_feed_mm_per_min", mm_per_min(s.plunge_feed), "mm/min");
    positive("spindle_rpm", s.spindle_rpm, "1/min");
    positive("depth_per_pass_mm", mm_from_m(s.depth_per_pass), "mm");
    positive("terrace_mm", mm_from_m(s.terrace), "mm");
    positive("wrap_feed_mm_per_min", mm_per_min(s.wrap_feed), "mm/min");
    positive("wrap_rpm", s.wrap_rpm, "1/min");
    positive("wrap_depth_mm", mm_from_m(s.wrap_depth), "mm");
    positive("safe_height_mm", mm_from_m(s.safe_height), "mm");
    core::require_within("machining.breakthrough_mm", mm_from_m(s.breakthrough), 0.0, 1000.0, "mm");
    positive("tolerance_mm", mm_from_m(s.tolerance), "mm");
    if (s.rotary_sign != 1 && s.rotary_sign != -1)
        throw core::InvalidInput("machining.rotary_sign", fmt::format("{}", s.rotary_sign), "1 or -1");
}

}  // namespace fusee::toolpath
