#include "fusee/exchange/three_mf.h"

#include <thread>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "exchange/fixtures/read_3mf.h"
#include "fusee/core/file.h"

namespace fusee::exchange {
namespace {

class ThreeMfTest : public fixtures::FolderTest {
protected:
    const solid::Mesh disc_ = fixtures::disc_mesh({20.0, 5.0, 1.0, 200});
};

TEST_F(ThreeMfTest, RoundtripKeepsUnitCountBoxAndVolume) {
    write_3mf(folder_ / "a.3mf", disc_, "k_se", "fusee test");
    const solid::Mesh back = read_3mf(folder_ / "a.3mf");
    EXPECT_EQ(back.triangles, disc_.triangles);
    ASSERT_EQ(back.points_mm.size(), disc_.points_mm.size());
    // printed to 1e-6 mm, from single precision (2^-20 mm at 25 mm)
    for (std::size_t i = 0; i < disc_.points_mm.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back.points_mm[i][k], disc_.points_mm[i][k], 3e-6);
    EXPECT_NEAR(solid::volume_mm3(back), fixtures::disc_volume_mm3({20.0, 5.0, 1.0, 200}), 5e-3);
}

TEST_F(ThreeMfTest, SameBytesTwiceAndFromManyThreads) {
    const std::vector<std::string> names{"a.3mf", "b.3mf", "c.3mf", "d.3mf"};
    std::vector<std::thread> threads;
    for (const std::string& name : names)
        threads.emplace_back([&, name] {
            write_3mf(folder_ / name, disc_, "k_se", "fusee test");
            EXPECT_EQ(read_3mf(folder_ / name).triangles.size(), disc_.triangles.size());
        });
    for (std::thread& t : threads) t.join();
    const std::string bytes = core::read_file(folder_ / names.front());
    for (const std::string& name : names) EXPECT_EQ(core::read_file(folder_ / name), bytes);
    write_3mf(folder_ / "other.3mf", disc_, "k_pe", "fusee test");
    EXPECT_NE(core::read_file(folder_ / "other.3mf"), bytes);
}

TEST_F(ThreeMfTest, KeepsAnObjectsColourAndAllItsShells) {
    solid::Mesh two = disc_;
    const auto first = static_cast<std::uint32_t>(two.points_mm.size());
    for (const solid::Vec3& p : disc_.points_mm) two.points_mm.push_back({p[0], p[1], p[2] + 40.0});
    for (const solid::Triangle& t : disc_.triangles) two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    write_3mf(folder_ / "a.3mf", {{"rods", two, Colour{200, 30, 10}}}, "fusee test");
    EXPECT_EQ(read_3mf(folder_ / "a.3mf").triangles, two.triangles);
    const auto colours = read_3mf_colours(folder_ / "a.3mf");
    ASSERT_EQ(colours.size(), two.triangles.size());
    EXPECT_EQ(colours.back(), (Colour{200, 30, 10}));
}

TEST_F(ThreeMfTest, RefusesAnOpenSurface) {
    solid::Mesh open = disc_;
    open.triangles.pop_back();
    EXPECT_THROW(write_3mf(folder_ / "open.3mf", open, "k_se", "fusee test"), core::InvalidInput);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "open.3mf"));
}

TEST_F(ThreeMfTest, RefusesBrokenFilesByName) {
    write_3mf(folder_ / "whole.3mf", disc_, "k_se", "fusee test");
    const std::string bytes = core::read_file(folder_ / "whole.3mf");
    core::write_file(folder_ / "cut.3mf", bytes.substr(0, bytes.size() / 2));
    core::write_file(folder_ / "text.3mf", "not a zip");
    core::write_file(folder_ / "empty.3mf", "");
    for (const char* name : {"cut.3mf", "text.3mf", "empty.3mf", "missing.3mf"})
        fixtures::expect_refusal([&] { (void)read_3mf(folder_ / name); }, {name});
}

}  // namespace
}  // namespace fusee::exchange
