#include "fusee/batch/batch.h"
#include "fusee/core/error.h"
#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

namespace fs = std::filesystem;

class LeavesNothing : public fixtures::TempFolder {
protected:
    batch::MakeResult make_with(const fixtures::Changes& changes) const {
        const std::string two_formats =
            fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "outputs.formats", R"(["stl", "3mf"])");
        const std::string text = fixtures::with_keys(two_formats, changes);
        return batch::make(profile::read_profile(write("t.toml", text)), {.out = folder_ / "out"});
    }
};

// The second is refused by its read-back, when all its files are written already.
TEST_F(LeavesNothing, ARefusalKeepsTheEarlierDesignAsItWas) {
    ASSERT_TRUE(make_with({}).made);
    const auto before = fixtures::contents(folder_ / "out");
    EXPECT_FALSE(make_with({{"k_pe.spring.preload_mm", "0.0"}}).made);
    EXPECT_TRUE(fixtures::contents(folder_ / "out") == before);
    EXPECT_FALSE(make_with({{"tolerances.chordal_error_mm", "1.0"}}).made);
    EXPECT_TRUE(fixtures::contents(folder_ / "out") == before);
}

TEST_F(LeavesNothing, ANewDesignReplacesTheEarlierOneAsAWhole) {
    ASSERT_TRUE(make_with({}).made);
    ASSERT_TRUE(make_with({{"outputs.formats", "[\"stl\"]"}}).made);
    EXPECT_FALSE(fs::exists(folder_ / "out" / "pnrvsa" / "k_se.3mf"));
    EXPECT_TRUE(fs::exists(folder_ / "out" / "pnrvsa" / "k_se.stl"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), fs::directory_iterator()), 1);
}

TEST_F(LeavesNothing, WhereNoFolderCanStand) {
    core::write_file(folder_ / "out", "a file");
    EXPECT_THROW((void)make_with({}), core::IoError);
    EXPECT_EQ(core::read_file(folder_ / "out"), "a file");
}

// A part that was changed after it was made, its entry with it: what is stated still has to be in the file.
TEST_F(LeavesNothing, ADamagedPartDoesNotPass) {
    const batch::MakeResult result = make_with({{"outputs.formats", "[\"stl\"]"}});
    ASSERT_TRUE(result.made);
    exchange::PartFile part = exchange::read_part_file(result.folder / "k_se.json");
    std::string bytes = core::read_file(result.folder / "k_se.stl");
    for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50)  // every triangle's three corners: x and y 1 % larger
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (std::size_t axis = 0; axis < 2; ++axis) {
                float value = 0.0F;
                char* place = bytes.data() + at + 12 + 12 * corner + 4 * axis;
                std::copy_n(place, sizeof value, reinterpret_cast<char*>(&value));
                value *= 1.01F;
                std::copy_n(reinterpret_cast<const char*>(&value), sizeof value, place);
            }
    core::write_file(result.folder / "k_se.stl", bytes);
    EXPECT_THROW((void)formats::read_back(result.folder, part), core::IoError) << "other bytes than stated";
    part.files.front().sha256 = core::sha256_hex(bytes);
    for (const readback::ArmError& e : formats::read_back(result.folder, part)) {
        EXPECT_FALSE(e.passed()) << e.reader;
        EXPECT_NEAR(e.worst_relative, 0.01, 1e-3) << "1 % of the floor; half a cable is added unscaled";
    }
}

}  // namespace
}  // namespace fusee::pipeline
