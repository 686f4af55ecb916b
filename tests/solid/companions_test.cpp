#include "fusee/solid/companions.h"

#include <gtest/gtest.h>

namespace fusee::solid {
namespace {

std::string joined(const core::Suggestion& suggestion) {
    std::string text;
    const auto all = suggestion.changes();
    EXPECT_EQ(all.size(), 1u) << "one alternative: " << suggestion.text();
    for (const core::Change& c : all.front()) text += c.key + "=" + c.value + ";";
    return text;
}

HubOptions keyed(double bore) {
    HubOptions hub;
    hub.bore_diameter = bore;
    return hub;
}

/// Bore 6.2 mm with a key 2 mm wide and 1 mm deep: its corner is hypot(4.1, 1) = 4.22 mm from the axis; 6 mm of bore and 1.5 mm of web.
TEST(Companions, NameEveryKeyThatTheHubNeeds) {
    EXPECT_EQ(joined(overhung_change("k_pe", keyed(6e-3))), "k_pe.hub.kind=\"overhung\";k_pe.hub.boss_mm=13;k_pe.hub.boss_height_mm=8;");
    EXPECT_EQ(joined(set_screw_change("k_se", keyed(6e-3))),
              "k_se.hub.lock=\"set_screw\";k_se.hub.screw_mm=3;k_se.hub.boss_mm=13;k_se.hub.boss_height_mm=7;");
}

TEST(Companions, LeaveWhatIsThereAlready) {
    HubOptions hub = keyed(6e-3);
    hub.boss_diameter = 16e-3, hub.boss_height = 12e-3;
    EXPECT_EQ(joined(overhung_change("k_pe", hub)), "k_pe.hub.kind=\"overhung\";");
}

/// A groove of a 1 mm cable: floor 1.06, flanks at 45 deg 3 mm, rib 1, slack 0.5.
TEST(Companions, GiveAHelixItsPitch) {
    EXPECT_EQ(joined(helix_change("k_pe", {}, 1e-3)), "k_pe.path.kind=\"helix\";k_pe.path.pitch_mm=5.6;");
    EXPECT_EQ(joined(constant_pitch_change("k_pe", {}, 1e-3)), "k_pe.path.lead=\"constant_pitch\";k_pe.path.pitch_mm=5.6;");
}

}  // namespace
}  // namespace fusee::solid
