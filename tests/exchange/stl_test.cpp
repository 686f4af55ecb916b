#include "fusee/exchange/stl.h"

#include <cstring>
#include <limits>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"

namespace fusee::exchange {
namespace {

using Read = solid::Mesh (*)(const std::filesystem::path&);

class StlTest : public fixtures::FolderTest {
protected:
    const solid::Mesh disc_ = fixtures::disc_mesh({});
    const std::vector<Read> readers_{read_stl_assimp, read_stl_openmesh};
};

TEST_F(StlTest, RoundtripKeepsUnitCountBoxAndVolume) {
    write_stl(folder_ / "a.stl", disc_, "fusee test");
    const solid::Box box = solid::bounding_box(disc_);
    for (const Read read : readers_) {
        const solid::Mesh back = read(folder_ / "a.stl");
        EXPECT_EQ(back.triangles.size(), disc_.triangles.size());
        EXPECT_EQ(back.points_mm.size(), disc_.points_mm.size());  // welded
        for (std::size_t i = 0; i < 3; ++i) {
            // single precision holds 25 mm to 2^-20 mm, one in the last place
            EXPECT_NEAR(solid::bounding_box(back).low_mm[i], box.low_mm[i], 2e-6);
            EXPECT_NEAR(solid::bounding_box(back).high_mm[i], box.high_mm[i], 2e-6);
        }
        // 1e-6 mm on a surface of 5,000 mm2
        EXPECT_NEAR(solid::volume_mm3(back), fixtures::disc_volume_mm3({}), 5e-3);
    }
}

TEST_F(StlTest, SameBytesTwiceAndNormalsPointOutward) {
    write_stl(folder_ / "a.stl", disc_, "fusee test");
    write_stl(folder_ / "b.stl", disc_, "fusee test");
    const std::string bytes = core::read_file(folder_ / "a.stl");
    EXPECT_EQ(bytes, core::read_file(folder_ / "b.stl"));
    EXPECT_EQ(bytes.substr(0, 10), "fusee test");
    EXPECT_EQ(bytes.size(), 84 + 50 * disc_.triangles.size());
    std::array<float, 3> normal{};
    std::memcpy(normal.data(), bytes.data() + 84, sizeof normal);  // the first triangle lies in the lower face
    EXPECT_EQ(normal, (std::array<float, 3>{0.0f, 0.0f, -1.0f}));
}

TEST_F(StlTest, RefusesAHeaderThatReadsAsText) { EXPECT_THROW(write_stl(folder_ / "a.stl", disc_, "solid part"), core::InvalidInput); }

TEST_F(StlTest, RefusesBrokenFilesByName) {
    write_stl(folder_ / "whole.stl", disc_, "fusee test");
    const std::string bytes = core::read_file(folder_ / "whole.stl");
    std::string nan = bytes, none = bytes.substr(0, 84);
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(nan.data() + 84 + 12, &not_a_number, sizeof not_a_number);
    std::memset(none.data() + 80, 0, 4);
    core::write_file(folder_ / "cut.stl", bytes.substr(0, bytes.size() / 2));
    core::write_file(folder_ / "long.stl", bytes + "x");
    core::write_file(folder_ / "nan.stl", nan);
    core::write_file(folder_ / "none.stl", none);
    core::write_file(folder_ / "short.stl", "fusee");
    for (const Read read : readers_)
        for (const char* name : {"cut.stl", "long.stl", "nan.stl", "none.stl", "short.stl", "missing.stl"})
            fixtures::expect_refusal([&] { (void)read(folder_ / name); }, {name});
}

TEST_F(StlTest, OpenMeshRefusesWhatIsNotManifold) {
    solid::Mesh fin = disc_;
    fin.points_mm.push_back({50.0, 0.0, 0.0});
    const solid::Triangle t = fin.triangles.back();
    fin.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(fin.points_mm.size() - 1)});
    write_stl(folder_ / "fin.stl", fin, "fusee test");
    fixtures::expect_refusal([&] { (void)read_stl_openmesh(folder_ / "fin.stl"); }, {"fin.stl", "not manifold"});
}

}  // namespace
}  // namespace fusee::exchange
