#include "fusee/exchange/step.h"

#include <cmath>
#include <thread>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"
#include "fusee/exchange/brep.h"
#include "solid/fixture.h"

namespace fusee::exchange {
namespace {

constexpr double kRadius_mm = 12.0, kEccentric_mm = 3.0, kCable_mm = 0.8;

class StepTest : public fixtures::FolderTest {
protected:
    void SetUp() override {
        fixtures::FolderTest::SetUp();
        const cam::Cam cam = solid::test::disc(kRadius_mm * 1e-3, kEccentric_mm * 1e-3, kCable_mm * 1e-3);
        brep_ = brep::build(solid::build_part(cam, solid::test::plain()).value()).value();
    }
    brep::Brep brep_;
};

TEST_F(StepTest, HoldsTheMaterialAndItsDensity) {
    write_step(folder_ / "a.step", brep_, "k_se", "fusee test", {"resin \u00e9, 'hard'", 1180.0});
    const std::string text = core::read_file(folder_ / "a.step");
    EXPECT_NE(text.find("DESCRIPTIVE_REPRESENTATION_ITEM('resin ?, ''hard'''"), std::string::npos);
    EXPECT_NE(text.find("PROPERTY_DEFINITION('material property','material name',"), std::string::npos);
    EXPECT_NE(text.find("POSITIVE_RATIO_MEASURE(1.18)"), std::string::npos) << "g/cm^3";
    EXPECT_EQ(StepFile(folder_ / "a.step").faces(), static_cast<std::size_t>(brep_.faces));
    write_step(folder_ / "b.step", brep_, "k_se", "fusee test");
    EXPECT_EQ(core::read_file(folder_ / "b.step").find("material"), std::string::npos);
}

TEST_F(StepTest, RoundtripKeepsFacesVolumeAndName) {
    write_step(folder_ / "a.step", brep_, "k_se", "fusee test");
    const StepFile back(folder_ / "a.step");
    EXPECT_EQ(back.faces(), brep_.faces);
    EXPECT_NEAR(back.volume_mm3() / brep_.volume_mm3, 1.0, 1e-6);
    EXPECT_EQ(back.product(), "k_se");
}

// Known answer: the ray from the axis at height 0 meets the floor, a circle of radius R - d/2 about (e, 0).
TEST_F(StepTest, RaysMeetTheFloor) {
    write_step(folder_ / "a.step", brep_, "k_se", "fusee test");
    const StepFile back(folder_ / "a.step");
    const double r = kRadius_mm - 0.5 * kCable_mm, e = kEccentric_mm;
    for (double a = 0.1; a < 6.2; a += 0.3) {
        const auto found = back.outermost(a, 0.0);
        ASSERT_TRUE(found) << a;
        EXPECT_NEAR(*found, e * std::cos(a) + std::sqrt(r * r - e * e * std::sin(a) * std::sin(a)), 3e-4) << a;
    }
    EXPECT_FALSE(back.outermost(0.0, 50.0));
}

// Known answer: about (e cos 0.8, e sin 0.8) the ray at azimuth a meets what the mirror image's ray meets at -a.
TEST_F(StepTest, AMirrorImagesRaysMeetTheFloorOnTheOtherSide) {
    cam::Cam cam = solid::test::disc(kRadius_mm * 1e-3, 0.0, kCable_mm * 1e-3);
    cam.path = [](double psi) {
        const double e = kEccentric_mm * 1e-3, at = psi - 0.8;
        return cam::PathPoint{psi, kRadius_mm * 1e-3 + e * std::cos(at), -e * std::sin(at), kRadius_mm * 1e-3, 0.0};
    };
    const auto image = brep::mirrored(brep::build(solid::build_part(cam, solid::test::plain()).value()).value());
    ASSERT_TRUE(image) << core::to_line(image.refusal().front());
    write_step(folder_ / "a.step", *image, "k_se_mirrored", "fusee test");
    const StepFile back(folder_ / "a.step");
    const double r = kRadius_mm - 0.5 * kCable_mm, e = kEccentric_mm;
    for (double a = 0.1; a < 6.2; a += 0.7) {
        const auto found = back.outermost(a, 0.0);
        ASSERT_TRUE(found) << a;
        const double from = a + 0.8;  // the image's centre lies at -0.8
        EXPECT_NEAR(*found, e * std::cos(from) + std::sqrt(r * r - e * e * std::sin(from) * std::sin(from)), 3e-4) << a;
    }
}

TEST_F(StepTest, SaysSchemaNameAndProvenanceAndNoTime) {
    write_step(folder_ / "a.step", brep_, "k_se", "fusee 1.2 of profile x");
    const std::string bytes = core::read_file(folder_ / "a.step");
    for (const char* part : {"AP242", "'k_se'", "fusee 1.2 of profile x", "1970-01-01T00:00:00"})
        EXPECT_NE(bytes.find(part), bytes.npos) << part;
}

TEST_F(StepTest, SameBytesTwiceAndFromManyThreads) {
    const std::vector<std::string> names{"a.step", "b.step", "c.step"};
    std::vector<std::thread> threads;
    for (const std::string& name : names)
        threads.emplace_back([&, name] {
            write_step(folder_ / name, brep_, "k_se", "fusee test");
            EXPECT_EQ(StepFile(folder_ / name).faces(), brep_.faces);
        });
    for (std::thread& t : threads) t.join();
    const std::string bytes = core::read_file(folder_ / names.front());
    for (const std::string& name : names) EXPECT_EQ(core::read_file(folder_ / name), bytes);
}

TEST_F(StepTest, RefusesBrokenFilesByName) {
    write_step(folder_ / "whole.step", brep_, "k_se", "fusee test");
    const std::string bytes = core::read_file(folder_ / "whole.step");
    core::write_file(folder_ / "cut.step", bytes.substr(0, bytes.size() / 2));
    core::write_file(folder_ / "text.step", "not STEP");
    core::write_file(folder_ / "empty.step", "");
    for (const char* name : {"cut.step", "text.step", "empty.step", "missing.step"})
        fixtures::expect_refusal([&] { (void)StepFile(folder_ / name); }, {name});
}

}  // namespace
}  // namespace fusee::exchange
