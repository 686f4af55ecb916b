#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "exchange/fixtures/disc.h"
#include "fusee/core/file.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/stl.h"
#include "fusee/solid/part.h"

namespace fusee::exchange {
namespace {

class MirroredStl : public fixtures::FolderTest {
protected:
    [[nodiscard]] std::string bytes(const solid::Mesh& mesh, const std::string& header) const {
        write_stl(folder_ / "a.stl", mesh, header);
        return core::read_file(folder_ / "a.stl");
    }
    const solid::Mesh disc_ = fixtures::disc_mesh({.columns = 40});
    const solid::Mesh image_ = solid::mirrored(disc_);
};

TEST_F(MirroredStl, IsProvenFromTheBytes) {
    const std::string right = bytes(disc_, "right"), left = bytes(image_, "left");
    EXPECT_TRUE(is_mirrored_stl(left, right));
    EXPECT_TRUE(is_mirrored_stl(right, left));
    EXPECT_FALSE(is_mirrored_stl(right, right));
}

// Every number counts: of each place in the file one bit is changed, from the first triangle's normal to its attribute.
TEST_F(MirroredStl, IsNotProvenWhereOneNumberDiffers) {
    const std::string right = bytes(disc_, "right"), left = bytes(image_, "left");
    constexpr std::size_t kTriangle = 84 + 50 * 7;
    for (std::size_t at = kTriangle; at < kTriangle + 50; at += at < kTriangle + 48 ? 4 : 1) {
        std::string broken = left;
        broken[at] = static_cast<char>(broken[at] ^ 1);
        EXPECT_FALSE(is_mirrored_stl(broken, right)) << at - kTriangle;
    }
    std::string unknown = left;
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(unknown.data() + kTriangle + 12, &not_a_number, sizeof not_a_number);
    EXPECT_FALSE(is_mirrored_stl(unknown, unknown));
}

TEST_F(MirroredStl, IsNotProvenForOtherTriangles) {
    const std::string right = bytes(disc_, "right");
    solid::Mesh fewer = image_, turned = image_;
    fewer.triangles.pop_back();
    std::rotate(turned.triangles[0].begin(), turned.triangles[0].begin() + 1, turned.triangles[0].end());
    EXPECT_FALSE(is_mirrored_stl(bytes(fewer, "left"), right));
    EXPECT_FALSE(is_mirrored_stl(bytes(turned, "left"), right));
    EXPECT_FALSE(is_mirrored_stl("", ""));
    EXPECT_FALSE(is_mirrored_stl(right.substr(0, 100), right.substr(0, 100)));
}

/// A disc's part towards an idler, and its image by hand.
struct Both {
    PartFile part = fixtures::disc_part({}, {"idler", {}, {20.0, 60.0}, 6.0, 1}, 1, 1);
    PartFile image = part;
    Both() {
        image.rotation_sign = image.torque_sign = image.guide.sense = -1;
        image.guide.position_mm[1] = -60.0;
        for (TargetRow& row : image.target) row.contact_mm[1] = -row.contact_mm[1];
    }
};

TEST(MirroredPartFile, HasEverySenseTheOtherWay) {
    Both both;
    both.image.provenance = "another";
    both.image.files = {{"b.stl", "", 12, 0.0}};
    EXPECT_TRUE(is_mirror_image(both.image, both.part));
    EXPECT_TRUE(is_mirror_image(both.part, both.image));
    EXPECT_FALSE(is_mirror_image(both.part, both.part));
}

TEST(MirroredPartFile, IsNotProvenWhereOneFigureDiffers) {
    const std::vector<std::function<void(PartFile&)>> changes{
        [](PartFile& p) { p.part = "k_pe"; },
        [](PartFile& p) { p.cable_diameter_mm += 1e-9; },
        [](PartFile& p) { p.rotation_sign = 1; },
        [](PartFile& p) { p.torque_sign = 1; },
        [](PartFile& p) { p.guide.kind = "point"; },
        [](PartFile& p) { p.guide.position_mm[0] += 1e-9; },
        [](PartFile& p) { p.guide.position_mm[1] = 60.0; },
        [](PartFile& p) {
            p.guide.direction = {0.0, 1.0};
        },
        [](PartFile& p) { p.guide.radius_mm += 1e-9; },
        [](PartFile& p) { p.guide.sense = 1; },
        [](PartFile& p) { p.guide.z_mm = 1e-9; },
        [](PartFile& p) { p.guide.offset_mm = 1e-9; },
        [](PartFile& p) { p.guide.start_mm = 1e-9; },
        [](PartFile& p) { p.spring_kind = "compression"; },
        [](PartFile& p) { p.spring_rate *= 1.0 + 1e-15; },
        [](PartFile& p) { p.spring_preload += 1e-9; },
        [](PartFile& p) { p.target.pop_back(); },
        [](PartFile& p) { p.target[7].angle_rad += 1e-12; },
        [](PartFile& p) { p.target[7].arm_mm = std::nextafter(p.target[7].arm_mm, 0.0); },
        [](PartFile& p) { p.target[7].load += 1e-9; },
        [](PartFile& p) { p.target[7].contact_mm[0] += 1e-9; },
        [](PartFile& p) { p.target[7].contact_mm[1] = -p.target[7].contact_mm[1]; },
        [](PartFile& p) { p.target[7].contact_mm[2] = 1e-9; },
        [](PartFile& p) { p.target[7].lift_mm = 1e-9; },
        [](PartFile& p) { p.target[7].stretch_mm = 1e-9; },
        [](PartFile& p) { p.compensated.emplace(); },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        Both both;
        changes[i](both.image);
        EXPECT_FALSE(is_mirror_image(both.image, both.part)) << i;
    }
}

}  // namespace
}  // namespace fusee::exchange
