#include "fusee/solid/stack.h"

#include <gtest/gtest.h>

#include "fixture.h"

namespace fusee::solid {
namespace {

using namespace test;

Part part_of(const cam::Cam& cam, const PartOptions& options) {
    Part part;
    part.cam = cam;
    part.options = options;
    part.section = groove_section(options.groove, cam.options.cable_diameter, 1e-5);
    return part;
}

// Known: between a bore of 2.6 mm and a floor of 19.6 mm about the same axis the largest circle is 17 mm wide, its middle 11.1 mm out.
TEST(Dowels, StandHalfWayBetweenBoreAndFloor) {
    const Dowels dowels = place_dowels(part_of(disc(0.02), plain()));
    EXPECT_NEAR(dowels.space_mm, 17.0, 2e-2);  // the bore's ring is a polygon within 5 micrometres, places are found to 1e-4 mm
    for (const Point2& c : dowels.centres_mm) EXPECT_NEAR(std::hypot(c[0], c[1]), 11.1, 1e-2);
    EXPECT_NEAR(dowels.centres_mm[0][0], -dowels.centres_mm[1][0], 1e-2) << "opposite";
    EXPECT_NEAR(dowels.centres_mm[0][1], -dowels.centres_mm[1][1], 1e-2);
}

// Law: no circle of the stated diameter around a dowel meets an opening or the floor.
TEST(Dowels, KeepClearOfEveryOpening) {
    PartOptions o = plain();
    o.hub.lock = HubLock::kKeyway;
    o.features.anchor_hole_diameter = 2e-3;
    o.features.leg_slot_width = 2e-3;
    o.features.leg_slot_length = 4e-3;
    o.features.leg_slot_radius = 6e-3;
    o.features.leg_slot_depth = 3e-3;
    o.features.leg_slot_angle = core::kPi / 2.0;
    const Part part = part_of(disc(0.012, 0.003), o);
    const Dowels dowels = place_dowels(part);
    EXPECT_GT(dowels.space_mm, kDowel_mm);
    for (const Plate& plate : stack_plates(part))
        for (const Opening& opening : plate.openings) {
            if (opening.name == "dowel") continue;
            for (const Point2& corner : ring_of(opening.outline, 1e-3))
                for (const Point2& c : dowels.centres_mm)
                    EXPECT_GT(std::hypot(corner[0] - c[0], corner[1] - c[1]), 0.5 * dowels.space_mm - 1e-2) << opening.name;
        }
    for (double psi = 0.0; psi < 2.0 * core::kPi; psi += 0.01)
        for (const Point2& c : dowels.centres_mm)
            EXPECT_GT(12.0 + 3.0 * std::cos(psi) - 0.4 - c[0] * std::cos(psi) - c[1] * std::sin(psi), 0.5 * dowels.space_mm - 1e-2);
}

TEST(Dowels, AreLeftOutWhereTheyHaveNoRoom) {
    PartOptions o = plain();
    o.hub.bore_diameter = 20e-3;
    const Part part = part_of(disc(0.012), o);  // 1.5 mm between bore and floor
    EXPECT_LT(place_dowels(part).space_mm, kDowel_mm);
    for (const Plate& plate : stack_plates(part)) EXPECT_EQ(plate.openings.size(), 1u) << "the bore";
}

TEST(Stack, SlotGoesThroughAsManyPlatesAsItIsDeep) {
    PartOptions o = plain();
    o.features.leg_slot_width = 1e-3;
    o.features.leg_slot_length = 3e-3;
    o.features.leg_slot_radius = 6e-3;
    o.groove.rib = 1.5e-3;
    o.groove.plate = 1e-3;
    const auto slotted = [&](double depth) {
        o.features.leg_slot_depth = depth;
        std::size_t count = 0;
        for (const Plate& plate : stack_plates(part_of(disc(), o)))
            for (const Opening& opening : plate.openings) count += opening.name == "leg_slot" ? 1 : 0;
        return count;
    };
    EXPECT_EQ(slotted(1.5e-3), 1u);
    EXPECT_EQ(slotted(2.0e-3), 2u);
    EXPECT_EQ(slotted(2.5e-3), 2u);
    EXPECT_EQ(slotted(3.0e-3), 3u);
}

TEST(Stack, CoreIsAsThickAsStatedOrTwoFloorRadii) {
    PartOptions o = plain();
    EXPECT_NEAR(core_thickness(part_of(disc(), o)), 2.0 * 0.53 * 0.8e-3, 1e-15);
    o.groove.plate = 1e-3;
    const std::vector<Plate> plates = stack_plates(part_of(disc(), o));
    EXPECT_EQ(plates[1].thickness_mm, 1.0);
    EXPECT_EQ(plates[0].thickness_mm, 1.0) << "the rib";
    EXPECT_NEAR(plates[1].offset_mm, -0.4, 1e-12);
}

/// Known: three discs about one axis, the middle one as wide as the groove's floor.
TEST(Stack, OfAProcessForSheetIsTheSolid) {
    PartOptions o = plain();
    o.groove.stacked = true;
    o.groove.rib = 1.5e-3;
    o.groove.plate = 1.2e-3;
    const auto part = build_part(disc(), o);
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->z_high - part->z_low, 4.2e-3, 1e-12);
    const double bore = 0.5e3 * (o.hub.bore_diameter + o.hub.bore_clearance);
    double volume = 0.0;
    for (const Plate& plate : stack_plates(*part))
        volume += core::kPi * (std::pow(12.0 + plate.offset_mm, 2) - bore * bore - 2.0 * 1.0) * plate.thickness_mm;  // two dowels of 2 mm
    EXPECT_NEAR(volume_mm3(part->mesh) / volume, 1.0, 5e-4);
    o.hub.boss_height = 5e-3;
    EXPECT_FALSE(is_stack(disc(), o)) << "a boss is no plate";
}

}  // namespace
}  // namespace fusee::solid
