#include <algorithm>
#include <array>
#include <set>

#include "fusee/batch/batch.h"
#include "fusee/core/error.h"
#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"
#include "fusee/pipeline/check.h"
#include "pipeline/fixture.h"

// Plates for a laser: asked for by the process, listed in PART.json, and their core carries the law.
namespace fusee::pipeline {
namespace {

using StackTest = fixtures::TempFolder;
namespace fs = std::filesystem;

/// The shipped example, one side of the joint only.
std::string example() {
    const std::string text = core::read_file(fs::path(FUSEE_SOURCE_DIR) / "profiles/examples/laser_stack.toml");
    return fixtures::with_keys(text, {{"outputs.pair", "false"}, {"outputs.plate", "false"}});
}

/// The arms read from a file, by their readers.
std::set<std::string> readers_of(const std::string& file, const std::vector<readback::ArmError>& errors) {
    std::set<std::string> readers;
    for (const readback::ArmError& e : errors)
        if (e.file == file) readers.insert(e.reader);
    return readers;
}

TEST_F(StackTest, OfTheExampleIsMadeAndItsCoreCarriesTheLaw) {
    const batch::MakeResult result = batch::make(profile::read_profile(write("p.toml", example())), {.out = folder_ / "out"});
    for (const core::Finding& f : result.findings) EXPECT_NE(f.severity, core::Severity::kError) << core::to_line(f);
    ASSERT_TRUE(result.made);
    for (const std::string part : {"k_se", "k_pe"}) {
        std::set<std::string> stated;
        const exchange::PartFile file = exchange::read_part_file(result.folder / (part + ".json"));
        for (const exchange::FileEntry& entry : file.files) stated.insert(entry.name);
        for (const char* number : {"1", "2", "3"}) {
            EXPECT_TRUE(stated.count(part + "_plate_" + number + ".dxf")) << number;
            EXPECT_FALSE(stated.count(part + "_plate_" + number + "_kerf.dxf")) << "compensated: not what the law says";
            EXPECT_TRUE(fs::exists(result.folder / (part + "_plate_" + number + "_kerf.dxf")));
        }
        const auto errors = formats::read_back(result.folder, file);
        EXPECT_EQ(readers_of(part + "_plate_2.dxf", errors), (std::set<std::string>{"dxflib", "dxflib, spline"}));
        EXPECT_TRUE(readers_of(part + "_plate_1.dxf", errors).empty()) << "a flange holds no groove";
        for (const readback::ArmError& e : errors) EXPECT_TRUE(e.passed()) << e.file << " " << e.reader << " " << e.worst_relative;
    }
}

TEST_F(StackTest, ACompensatedCoreIsNotTakenForTheNominalOne) {
    const std::string toml = fixtures::with_key(example(), "outputs.formats", "[\"plates\"]");
    const batch::MakeResult result = batch::make(profile::read_profile(write("p.toml", toml)), {.out = folder_ / "out"});
    ASSERT_TRUE(result.made);
    exchange::PartFile part = exchange::read_part_file(result.folder / "k_se.json");
    std::erase_if(part.files, [](const exchange::FileEntry& f) { return f.name != "k_se_plate_2.dxf"; });
    fs::copy_file(result.folder / "k_se_plate_2_kerf.dxf", result.folder / "k_se_plate_2.dxf", fs::copy_options::overwrite_existing);
    part.files.at(0).sha256 = core::sha256_hex(core::read_file(result.folder / "k_se_plate_2.dxf"));
    EXPECT_THROW((void)formats::read_back(result.folder, part), core::IoError) << "a compensated drawing has no spline";
}

TEST_F(StackTest, IsWrittenForPlatesOnlyUnlessAskedFor) {
    const auto plates_of = [&](const std::string& toml) { return profile::read_profile(write("p.toml", toml)).outputs.has("plates"); };
    EXPECT_TRUE(plates_of(example()));
    EXPECT_FALSE(plates_of(fixtures::with_key(example(), "process.kind", "\"fdm\"")));
    EXPECT_FALSE(plates_of(fixtures::with_key(example(), "outputs.formats", "[\"dxf\"]")));
    EXPECT_TRUE(plates_of(fixtures::with_keys(example(), {{"process.kind", "\"mill\""}, {"outputs.formats", "[\"plates\"]"}})));
}

// Judged for a printer it is one piece with a round groove, which needs no support.
TEST_F(StackTest, OfAnotherProcessIsOnePiece) {
    const std::array kinds{checks::ProcessKind::kFdm, checks::ProcessKind::kLaser};
    const Checked checked = check(profile::read_profile(write("p.toml", example())), kinds);
    const auto overhangs = [&](std::size_t which) {
        const core::Findings all = checked.processes.at(which).all();
        return std::any_of(all.begin(), all.end(),
                           [](const core::Finding& f) { return f.rule == "collision.printed_throat" && core::is_broken(f); });
    };
    EXPECT_FALSE(overhangs(0));
    EXPECT_FALSE(overhangs(1));
    EXPECT_FALSE(core::any_error(checked.processes.at(1).all()));
}

// A boss is no plate: said, and nothing drawn that lacks it.
TEST_F(StackTest, OfAPartWithABossIsForReview) {
    const std::string toml = fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "outputs.formats", "[\"plates\"]");
    const batch::MakeResult result = batch::make(profile::read_profile(write("p.toml", toml)), {.out = folder_ / "out"});
    ASSERT_TRUE(result.made);
    EXPECT_TRUE(fs::exists(result.folder / "k_se_plate_1.dxf"));
    EXPECT_FALSE(fs::exists(result.folder / "k_pe_plate_1.dxf"));
    EXPECT_TRUE(std::any_of(result.findings.begin(), result.findings.end(), [](const core::Finding& f) {
        return f.rule == "stack.boss" && f.severity == core::Severity::kWarning && f.where == "k_pe";
    }));
}

}  // namespace
}  // namespace fusee::pipeline
