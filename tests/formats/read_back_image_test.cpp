#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/formats/format.h"
#include "fusee/solid/part.h"

namespace fusee::formats {
namespace {

/// A disc that was read back, and its mirror image.
class ReadBackImage : public fixtures::FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        file_ = fixtures::disc_part({}, {"parallel", {std::cos(0.7), std::sin(0.7)}, {}, 0.0, 1}, 1, 1);
        image_ = file_;
        image_.rotation_sign = image_.torque_sign = -1;
        image_.guide.direction[1] = -image_.guide.direction[1];
        for (exchange::TargetRow& row : image_.target) row.contact_mm[1] = -row.contact_mm[1];
        add(file_, "k_se.stl", mesh_);
        add(image_, "k_se_mirrored.stl", solid::mirrored(mesh_));
    }
    void add(exchange::PartFile& part, const std::string& name, const solid::Mesh& mesh) const {
        if (name.ends_with(".stl"))
            exchange::write_stl(folder_ / name, mesh, "fusee test");
        else
            exchange::write_3mf(folder_ / name, mesh, "k_se", "fusee test");
        part.files.push_back({name, core::sha256_hex(core::read_file(folder_ / name)), mesh.triangles.size(), 0.002});
    }
    [[nodiscard]] ReadPart read() const { return {file_, read_back(folder_, file_)}; }

    const solid::Mesh mesh_ = fixtures::disc_mesh({});
    exchange::PartFile file_, image_;
};

// Two ways to the same arms: taken over, and read. Rays in mirrored directions round differently.
TEST_F(ReadBackImage, TakesOverTheArmsOfAProvenImage) {
    const auto errors = read_back_image(folder_, image_, read()), full = read_back(folder_, image_);
    ASSERT_EQ(errors.size(), 2u);
    ASSERT_EQ(full.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(errors[i].file, "k_se_mirrored.stl");
        EXPECT_EQ(errors[i].mirror_of, "k_se.stl");
        EXPECT_EQ(full[i].mirror_of, "");
        EXPECT_EQ(errors[i].reader, full[i].reader);
        EXPECT_EQ(errors[i].rows, full[i].rows);
        EXPECT_NEAR(errors[i].worst_relative, full[i].worst_relative, 1e-7);
        for (std::size_t row = 0; row < full[i].arms_mm.size(); ++row) EXPECT_NEAR(errors[i].arms_mm[row], full[i].arms_mm[row], 1e-5);
    }
}

TEST_F(ReadBackImage, ReadsABrokenImageAndFindsItsLump) {
    image_.files.clear();
    add(image_, "k_se_mirrored.stl", solid::mirrored(fixtures::disc_mesh({.bulge_mm = 0.1, .bulge_at = 5.1})));
    const auto errors = read_back_image(folder_, image_, read());
    ASSERT_EQ(errors.size(), 2u);
    for (const readback::ArmError& error : errors) {
        EXPECT_EQ(error.mirror_of, "");
        EXPECT_FALSE(error.passed()) << error.worst_relative;
    }
}

TEST_F(ReadBackImage, ReadsAnImageOfAnotherLaw) {
    for (exchange::TargetRow& row : image_.target) row.arm_mm *= 1.01;
    for (const readback::ArmError& error : read_back_image(folder_, image_, read())) {
        EXPECT_EQ(error.mirror_of, "");
        EXPECT_FALSE(error.passed());
    }
}

TEST_F(ReadBackImage, ReadsFormatsWithoutAProof) {
    add(file_, "k_se.3mf", mesh_);
    add(image_, "k_se_mirrored.3mf", solid::mirrored(mesh_));
    const auto errors = read_back_image(folder_, image_, read());
    ASSERT_EQ(errors.size(), 3u);
    EXPECT_EQ(errors[2].reader, "lib3mf");
    EXPECT_EQ(errors[2].mirror_of, "");
    EXPECT_TRUE(errors[2].passed());
}

TEST_F(ReadBackImage, RefusesBytesThatAreNotAsStated) {
    const ReadPart part = read();
    image_.files[0].sha256 = "0";
    fixtures::expect_refusal([&] { (void)read_back_image(folder_, image_, part); }, {"k_se_mirrored.stl", "SHA-256"});
}

}  // namespace
}  // namespace fusee::formats
