#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/readback/readback.h"

namespace fusee::readback {
namespace {

/// Two discs of known arms, one of them turned and with its centre on the other side of the axis.
class PlateReadBack : public fixtures::FolderTest {
protected:
    void SetUp() override {
        fixtures::FolderTest::SetUp();
        const exchange::PartGuide along_y{"parallel", {0.0, 1.0}};
        exchange::write_part_file(folder_ / "k_se.json", fixtures::disc_part(first_, along_y, 1, 1));
        exchange::write_part_file(folder_ / "k_pe.json", fixtures::disc_part(second_, along_y, 1, -1));
    }
    /// @param stated places of plate.json, where they differ from those at which the objects stand
    [[nodiscard]] exchange::Plate written(const std::vector<exchange::PlateObject>& places,
                                          const std::vector<exchange::PlateObject>& stated = {}) const {
        const std::vector<exchange::NamedMesh> objects{{"k_se", exchange::placed(fixtures::disc_mesh(first_), places[0])},
                                                       {"k_pe", exchange::placed(fixtures::disc_mesh(second_), places[1])}};
        exchange::write_3mf(folder_ / "plate.3mf", objects, "fusee test");
        const std::size_t triangles = objects[0].mesh.triangles.size() + objects[1].mesh.triangles.size();
        return {{"plate.3mf", core::sha256_hex(core::read_file(folder_ / "plate.3mf")), triangles, 0.002},
                {200.0, 200.0, 100.0},
                5.0,
                stated.empty() ? places : stated,
                "fusee test"};
    }

    const fixtures::Disc first_{20.0, 5.0, 1.0, 400}, second_{15.0, -4.0, 1.0, 400};
    const std::vector<exchange::PlateObject> places_{{"k_se", false, {40.0, 50.0, 2.0}}, {"k_pe", true, {120.0, 90.0, 2.0}}};
};

TEST_F(PlateReadBack, FindsTheArmOfEveryObjectWhereItStands) {
    const auto errors = read_back_plate(folder_, written(places_));
    ASSERT_EQ(errors.size(), 2u);
    EXPECT_EQ(errors[0].file, "plate.3mf");
    EXPECT_EQ(errors[0].reader, "lib3mf k_se");
    EXPECT_EQ(errors[1].reader, "lib3mf k_pe");
    // A polygon of 400 sides is 3.1e-5 of the radius inside its circle, at least 1.4 times as much of the least arm.
    for (const ArmError& e : errors) EXPECT_LT(e.worst_relative, 5e-5) << e.reader;
}

// A tenth of a millimetre is 0.5 % of these arms.
TEST_F(PlateReadBack, SeesAPlaceThatIsNotTheObjects) {
    auto stated = places_;
    stated[0].moved_mm[0] += 0.1;
    const auto errors = read_back_plate(folder_, written(places_, stated));
    EXPECT_FALSE(errors[0].passed());
    EXPECT_NEAR(errors[0].worst_relative, 0.1 / 25.0, 1e-3);
    EXPECT_TRUE(errors[1].passed());
}

TEST_F(PlateReadBack, RefusesWhatIsNotArrangedOrNotStated) {
    const auto read = [this](const exchange::Plate& plate) { return [this, plate] { (void)read_back_plate(folder_, plate); }; };
    auto near = places_;
    near[1].moved_mm = {76.0, 50.0, 2.0};
    fixtures::expect_refusal(read(written(near)), {"plate.3mf", "k_se and k_pe", "nearer than 5 mm"});
    auto out = places_;
    out[1].moved_mm[1] = 195.0;
    fixtures::expect_refusal(read(written(out)), {"plate.3mf", "k_pe", "beyond the build volume along y"});
    auto other = places_;
    other[1].name = "k_pe_mirrored";
    fixtures::expect_refusal(read(written(places_, other)), {"plate.3mf", "stated objects"});
    exchange::Plate plate = written(places_);
    plate.file.sha256 = "0";
    fixtures::expect_refusal(read(plate), {"plate.3mf", "stated objects"});
}

}  // namespace
}  // namespace fusee::readback
