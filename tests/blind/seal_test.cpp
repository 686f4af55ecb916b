#include <gtest/gtest.h>
#include <unistd.h>

#include "fusee/blind/blind.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fusee::blind {
namespace {

namespace fs = std::filesystem;

class Seal : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        sealed_ = seal_labels(labels_, 9);
        hash_ = core::sha256_hex(sealed_);
        core::write_file(folder_ / "labels.sealed", sealed_);
        core::write_file(folder_ / "seal.txt", "sha256:" + hash_ + "\n");
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_ = fs::temp_directory_path() / ("fusee_seal_" + std::to_string(getpid()));
    std::vector<Label> labels_{{"case000", {}, true},
                               {"case001", {{"gear.stribeck", "agonist", 0.6180339887498949, {{"speed_rad_per_s", 0.1}}}}, true},
                               {"case002", {{"outside.harness", "none", 0.1, {{"hardening_Nm_per_rad3", 0.2}}}}, false}};
    std::string sealed_, hash_;
};

TEST_F(Seal, GivesTheLabelsBack) {
    EXPECT_EQ(open_seal(folder_, hash_), labels_);
    EXPECT_EQ(open_seal(folder_, "sha256:" + hash_), labels_);
}

TEST_F(Seal, IsNotReadByAccidentAndIsSalted) {
    EXPECT_EQ(sealed_.find("gear"), std::string::npos);
    EXPECT_EQ(sealed_.find("case"), std::string::npos);
    EXPECT_NE(core::sha256_hex(seal_labels({}, 1)), core::sha256_hex(seal_labels({}, 2)));
}

TEST_F(Seal, RefusesWhatWasTamperedWith) {
    // Another set of labels, sealed properly, under the old hash.
    core::write_file(folder_ / "labels.sealed", seal_labels({{"case000", {}, true}}, 9));
    EXPECT_THROW(static_cast<void>(open_seal(folder_, hash_)), core::InvalidInput);
    // One changed character.
    std::string changed = sealed_;
    changed[40] = changed[40] == 'A' ? 'B' : 'A';
    core::write_file(folder_ / "labels.sealed", changed);
    EXPECT_THROW(static_cast<void>(open_seal(folder_, hash_)), core::InvalidInput);
    EXPECT_THROW(static_cast<void>(open_seal(folder_, core::sha256_hex(changed))), core::InvalidInput);  // seal.txt names the old one
    core::write_file(folder_ / "labels.sealed", sealed_);
    core::write_file(folder_ / "seal.txt", "sha256:0123\n");
    EXPECT_THROW(static_cast<void>(open_seal(folder_, hash_)), core::InvalidInput);
}

TEST_F(Seal, NothingThereIsAnIoError) { EXPECT_THROW(static_cast<void>(open_seal(folder_ / "none", hash_)), core::IoError); }

}  // namespace
}  // namespace fusee::blind
