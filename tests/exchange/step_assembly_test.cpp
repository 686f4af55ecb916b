#include <thread>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/exchange/brep.h"
#include "fusee/exchange/step.h"

namespace fusee::exchange {
namespace {

using Eigen::Vector3d;

solid::Extrusion round(double radius_mm, double length_mm, double x_mm = 0.0, std::vector<solid::RoundHole> holes = {}) {
    solid::Extrusion shape;
    shape.frame.translation() = Vector3d(x_mm, 0.0, 0.0);
    shape.radius_mm = radius_mm, shape.length_mm = length_mm, shape.holes = std::move(holes);
    return shape;
}

std::shared_ptr<const TopoDS_Shape> made(std::vector<solid::Extrusion> shapes) { return brep::extruded(shapes).value().shape; }

/// A shaft along x, a ring on it, and a body of two rods.
std::vector<StepInstance> three() {
    const Eigen::Isometry3d along_x(Eigen::Translation3d(5.0, 6.0, 7.0) * Eigen::AngleAxisd(0.5 * core::kPi, Vector3d::UnitY()));
    return {{"shaft", made({round(2.0, 30.0)}), along_x, {200, 30, 10}},
            {"ring", made({round(5.0, 4.0, 0.0, {{0.0, 0.0, 2.0}})}), Eigen::Translation3d(10.0, 0.0, 0.0) * along_x, {10, 100, 220}},
            {"rods", made({round(1.0, 9.0), round(1.0, 9.0, 20.0)}), Eigen::Isometry3d(Eigen::Translation3d(0.0, 50.0, 0.0)), {0, 255, 0}}};
}

class StepAssemblyTest : public fixtures::FolderTest {};

TEST_F(StepAssemblyTest, RoundtripKeepsNamesPlacesAndVolumes) {
    write_step_assembly(folder_ / "a.step", three(), "joint", "fusee test");
    const auto back = read_step_assembly(folder_ / "a.step");
    ASSERT_EQ(back.size(), 3U);
    const std::vector<std::string> names{"shaft", "ring", "rods"};
    const std::vector<double> volumes{120.0 * core::kPi, 84.0 * core::kPi, 18.0 * core::kPi};
    const std::vector<solid::Vec3> low{{5.0, 4.0, 5.0}, {15.0, 1.0, 2.0}, {-1.0, 49.0, 0.0}},
        high{{35.0, 8.0, 9.0}, {19.0, 11.0, 12.0}, {21.0, 51.0, 9.0}};
    for (std::size_t i = 0; i < 3; ++i) {
        SCOPED_TRACE(names[i]);
        EXPECT_EQ(back[i].name, names[i]);
        EXPECT_EQ(back[i].product, names[i]);
        EXPECT_EQ(back[i].solids, i == 2 ? 2U : 1U);
        EXPECT_NEAR(back[i].volume_mm3, volumes[i], 1e-6);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(back[i].box.low_mm[k], low[i][k], 1e-5);
            EXPECT_NEAR(back[i].box.high_mm[k], high[i][k], 1e-5);
        }
    }
}

TEST_F(StepAssemblyTest, EqualBodiesAreProductsOfTheirOwn) {
    const Eigen::Isometry3d aside(Eigen::Translation3d(0.0, 50.0, 0.0));
    write_step_assembly(folder_ / "a.step", {{"left", made({round(2.0, 30.0)})}, {"right", made({round(2.0, 30.0)}), aside}}, "joint", "");
    const auto back = read_step_assembly(folder_ / "a.step");
    ASSERT_EQ(back.size(), 2U);
    EXPECT_EQ(back[0].product, "left");
    EXPECT_EQ(back[1].product, "right");
    EXPECT_NEAR(back[1].box.low_mm[1], 48.0, 1e-5);
}

// The shaft fills the ring's bore: they touch. A ring moved along z by its bore's diameter meets the shaft with its wall.
TEST_F(StepAssemblyTest, FindsBodiesThatInterfereAndNotThoseThatTouch) {
    std::vector<StepInstance> instances = three();
    write_step_assembly(folder_ / "a.step", instances, "joint", "fusee test");
    EXPECT_TRUE(interferences(read_step_assembly(folder_ / "a.step"), 1e-6).empty());
    instances[1].placement.translation().z() += 4.0;
    write_step_assembly(folder_ / "b.step", instances, "joint", "fusee test");
    const auto found = interferences(read_step_assembly(folder_ / "b.step"), 1e-6);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().a, "shaft");
    EXPECT_EQ(found.front().b, "ring");
    EXPECT_GT(found.front().common_mm3, 20.0);
}

TEST_F(StepAssemblyTest, SaysSchemaInstancesColoursAndNoTime) {
    write_step_assembly(folder_ / "a.step", three(), "joint", "fusee 1.2 of profile x");
    const std::string bytes = core::read_file(folder_ / "a.step");
    const auto count = [&](const std::string& word) {
        std::size_t n = 0;
        for (std::size_t at = 0; (at = bytes.find(word, at)) != bytes.npos; at += word.size()) ++n;
        return n;
    };
    for (const char* part : {"AP242", "PRODUCT('joint','joint'", "NEXT_ASSEMBLY_USAGE_OCCURRENCE('ring','ring'", "fusee 1.2 of profile x",
                             "1970-01-01T00:00:00", "COLOUR_RGB('',0.784313"})
        EXPECT_EQ(count(part), 1U) << part;
    EXPECT_EQ(count("= STYLED_ITEM("), 4U) << "one for each solid";
    EXPECT_EQ(count("= PRODUCT("), 6U) << "three bodies, the two solids of one, and the assembly";
    EXPECT_EQ(count("NEXT_ASSEMBLY_USAGE_OCCURRENCE('rods_2','rods_2'"), 1U);
}

TEST_F(StepAssemblyTest, SameBytesTwiceAndFromManyThreads) {
    const std::vector<std::string> names{"a.step", "b.step", "c.step"};
    std::vector<std::thread> threads;
    for (const std::string& name : names)
        threads.emplace_back([&, name] { write_step_assembly(folder_ / name, three(), "joint", "fusee test"); });
    for (std::thread& thread : threads) thread.join();
    const std::string bytes = core::read_file(folder_ / "a.step");
    for (const std::string& name : names) EXPECT_EQ(core::read_file(folder_ / name), bytes);
}

TEST_F(StepAssemblyTest, RefusesNamesThatAreNotDifferentAndFilesWithoutInstances) {
    std::vector<StepInstance> instances = three();
    instances[1].name = "shaft";
    EXPECT_THROW(write_step_assembly(folder_ / "a.step", instances, "joint", ""), core::InvalidInput);
    EXPECT_THROW(write_step_assembly(folder_ / "a.step", {}, "joint", ""), core::InvalidInput);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.step"));
    core::write_file(folder_ / "text.step", "not STEP");
    fixtures::expect_refusal([&] { (void)read_step_assembly(folder_ / "text.step"); }, {"text.step"});
}

}  // namespace
}  // namespace fusee::exchange
