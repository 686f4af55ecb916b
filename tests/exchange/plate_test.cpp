#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/three_mf.h"

namespace fusee::exchange {
namespace {

class PlateTest : public fixtures::FolderTest {
protected:
    [[nodiscard]] static Plate plate() {
        return {{"plate.3mf", "ab12", 4000, 0.002},
                {200.0, 210.5, 180.0},
                5.0,
                {{"k_se", false, {12.25, 31.0, 4.0}}, {"k_se_mirrored", true, {100.0, 0.1, 4.0}, true}},
                "fusee test"};
    }
    const solid::Mesh disc_ = fixtures::disc_mesh({20.0, 5.0, 1.0, 200});
};

TEST_F(PlateTest, FileGivesBackWhatWasWritten) {
    write_plate_file(folder_ / "plate.json", plate());
    const Plate back = read_plate_file(folder_ / "plate.json");
    EXPECT_EQ(back.file.name, "plate.3mf");
    EXPECT_EQ(back.file.triangles, 4000u);
    EXPECT_EQ(back.build_mm, plate().build_mm);
    EXPECT_EQ(back.spacing_mm, 5.0);
    EXPECT_EQ(back.provenance, "fusee test");
    ASSERT_EQ(back.objects.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(back.objects[i].name, plate().objects[i].name);
        EXPECT_EQ(back.objects[i].turned, plate().objects[i].turned);
        EXPECT_EQ(back.objects[i].flipped, plate().objects[i].flipped);
        EXPECT_EQ(back.objects[i].moved_mm, plate().objects[i].moved_mm);
    }
}

// Known: half a turn about +x takes (x, y, z) to (x, -y, -z), before the quarter turn.
TEST_F(PlateTest, LaysAPartOnItsTopAndTakesBack) {
    const PlateObject flipped{"a", true, {10.0, 20.0, 3.0}, true};
    const solid::Mesh corner{{{1.0, 2.0, 0.5}}, {}};
    EXPECT_EQ(placed(corner, flipped).points_mm.front(), (solid::Vec3{12.0, 21.0, 2.5}));
    EXPECT_EQ(taken_back(placed(corner, flipped), flipped).points_mm.front(), corner.points_mm.front());
    EXPECT_NEAR(solid::volume_mm3(placed(disc_, flipped)), solid::volume_mm3(disc_), 1e-6) << "no mirror: it still faces outward";
}

// Known: a quarter turn takes (x, y) to (-y, x).
TEST_F(PlateTest, PlacesByAQuarterTurnAndAMoveAndTakesBack) {
    const PlateObject turned{"a", true, {10.0, 20.0, 3.0}};
    const solid::Mesh corner{{{1.0, 2.0, 0.5}}, {}};
    EXPECT_EQ(placed(corner, turned).points_mm.front(), (solid::Vec3{8.0, 21.0, 3.5}));
    EXPECT_EQ(taken_back(placed(corner, turned), turned).points_mm.front(), corner.points_mm.front());
    EXPECT_DOUBLE_EQ(solid::volume_mm3(placed(disc_, {"a", false, {}})), solid::volume_mm3(disc_));
    EXPECT_NEAR(solid::volume_mm3(placed(disc_, turned)), solid::volume_mm3(disc_), 1e-6) << "no mirror: it still faces outward";
}

TEST_F(PlateTest, ThreeMfHoldsEveryObjectByName) {
    const std::vector<NamedMesh> objects{{"k_se", disc_}, {"k_pe", placed(disc_, {"k_pe", false, {60.0, 0.0, 0.0}})}};
    write_3mf(folder_ / "plate.3mf", objects, "fusee test");
    const std::vector<NamedMesh> back = read_3mf_objects(folder_ / "plate.3mf");
    ASSERT_EQ(back.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(back[i].name, objects[i].name);
        EXPECT_EQ(back[i].mesh.triangles, objects[i].mesh.triangles);
        for (std::size_t k = 0; k < 3; ++k)  // printed to 1e-6 mm, from single precision (2^-18 mm at 85 mm)
            EXPECT_NEAR(solid::bounding_box(back[i].mesh).low_mm[k], solid::bounding_box(objects[i].mesh).low_mm[k], 6e-6);
    }
    fixtures::expect_refusal([&] { (void)read_3mf(folder_ / "plate.3mf"); }, {"plate.3mf", "more than one"});
    write_3mf(folder_ / "again.3mf", objects, "fusee test");
    EXPECT_EQ(core::read_file(folder_ / "again.3mf"), core::read_file(folder_ / "plate.3mf"));
}

TEST_F(PlateTest, RefusesBrokenFilesByNameAndKey) {
    const auto with = [&](const std::string& from, const std::string& to) {
        write_plate_file(folder_ / "plate.json", plate());
        std::string text = core::read_file(folder_ / "plate.json");
        text.replace(text.find(from), from.size(), to);
        core::write_file(folder_ / "plate.json", text);
        return [this] { (void)read_plate_file(folder_ / "plate.json"); };
    };
    fixtures::expect_refusal(with("\"turned_deg\": 90", "\"turned_deg\": 45"), {"plate.json", "objects[1].turned_deg", "0 or 90"});
    fixtures::expect_refusal(with("\"flipped_deg\": 180", "\"flipped_deg\": 90"), {"plate.json", "objects[1].flipped_deg", "0 or 180"});
    fixtures::expect_refusal(with("\"spacing_mm\"", "\"space_mm\""), {"plate.json", "spacing_mm: missing"});
    fixtures::expect_refusal(with("plate.3mf", "../plate.3mf"), {"plate.json", "file.name"});
}

}  // namespace
}  // namespace fusee::exchange
