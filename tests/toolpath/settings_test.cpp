#include "fusee/toolpath/settings.h"

#include <functional>

#include "fusee/core/error.h"
#include "toolpath/fixture.h"

namespace fusee::toolpath {
namespace {

TEST(MachiningSettings, DefaultsAreValid) { EXPECT_NO_THROW(require_valid({})); }

TEST(MachiningSettings, BadOnesAreRefusedByName) {
    const std::vector<std::pair<const char*, std::function<void(Settings&)>>> spoiled{
        {"machining.tool_diameter_mm", [](Settings& s) { s.tool_diameter = 0.0; }},
        {"machining.feed_mm_per_min", [](Settings& s) { s.feed = -1.0; }},
        {"machining.plunge_feed_mm_per_min", [](Settings& s) { s.plunge_feed = -1.0; }},
        {"machining.spindle_rpm", [](Settings& s) { s.spindle_rpm = std::nan(""); }},
        {"machining.depth_per_pass_mm", [](Settings& s) { s.depth_per_pass = 0.0; }},
        {"machining.terrace_mm", [](Settings& s) { s.terrace = 0.0; }},
        {"machining.wrap_feed_mm_per_min", [](Settings& s) { s.wrap_feed = -1.0; }},
        {"machining.wrap_rpm", [](Settings& s) { s.wrap_rpm = 0.0; }},
        {"machining.wrap_depth_mm", [](Settings& s) { s.wrap_depth = -1e-3; }},
        {"machining.safe_height_mm", [](Settings& s) { s.safe_height = 0.0; }},
        {"machining.breakthrough_mm", [](Settings& s) { s.breakthrough = -1e-3; }},
        {"machining.tolerance_mm", [](Settings& s) { s.tolerance = 0.0; }},
        {"machining.flute_length_mm", [](Settings& s) { s.flute_length = 0.0; }},
        {"machining.stick_out_mm", [](Settings& s) { s.stick_out = 0.0; }},
        {"machining.holder_diameter_mm", [](Settings& s) { s.holder_diameter = -1.0; }},
        {"machining.chuck_diameter_mm", [](Settings& s) { s.chuck_diameter = 0.0; }},
        {"machining.tab_width_mm", [](Settings& s) { s.tab_width = 0.0; }},
        {"machining.spindle_rpm", [](Settings& s) { s.spindle_rpm = 25000.0; }},
        {"machining.wrap_rpm", [](Settings& s) { s.spindle_max_rpm = 18000.0; }},
        {"machining.rotary_sign", [](Settings& s) { s.rotary_sign = 0; }},
    };
    for (const auto& [key, spoil] : spoiled) {
        Settings settings;
        spoil(settings);
        try {
            (void)part_programs(disc(), settings, "test");
            ADD_FAILURE() << key;
        } catch (const core::InvalidInput& error) {
            EXPECT_EQ(error.field(), key);
        }
    }
}

}  // namespace
}  // namespace fusee::toolpath
