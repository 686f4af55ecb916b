#include <regex>

#include "fusee/batch/batch.h"
#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"
#include "pipeline/fixture.h"

// docs/guides/add-a-format.md: its format is a name of `outputs.formats`, its files are exported and read back, and the named files exist.
namespace fusee::formats {
namespace {

using Guide = fixtures::TempFolder;

TEST_F(Guide, TheFormatIsExportedAndReadBack) {
    const std::string text = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")), {{"outputs.formats", R"(["off"])"},
                                                                                                {"outputs.pair", "false"},
                                                                                                {"k_se.target_rows", "200"},
                                                                                                {"k_pe.target_rows", "200"},
                                                                                                {"tolerances.chordal_error_mm", "0.003"}});
    const batch::MakeResult result = batch::make(profile::read_profile(write("p.toml", text)), {.out = folder_ / "out"});
    ASSERT_TRUE(result.made);
    for (const std::string part : {"k_se", "k_pe"}) {
        const exchange::PartFile file = exchange::read_part_file(result.folder / (part + ".json"));
        ASSERT_EQ(file.files.size(), 1u);
        EXPECT_EQ(file.files[0].name, part + ".off");
        const auto errors = read_back(result.folder, file);
        ASSERT_EQ(errors.size(), 1u);
        EXPECT_TRUE(errors[0].passed()) << errors[0].worst_relative;
    }
}

TEST_F(Guide, NamesFilesThatExist) {
    const fixtures::fs::path source = FUSEE_SOURCE_DIR;
    const std::string page = core::read_file(source / "docs/guides/add-a-format.md");
    const std::regex path("`((?:src|include|tests)/[a-z_/]+(?:\\.cpp|\\.h)?)`");
    int files = 0;
    for (std::sregex_iterator at(page.begin(), page.end(), path), end; at != end; ++at, ++files) {
        const std::string name = (*at)[1];
        EXPECT_TRUE(fixtures::fs::exists(source / name) || name == "src/formats/off.cpp" || name == "tests/formats/off_test.cpp") << name;
    }
    EXPECT_GT(files, 5);
}

}  // namespace
}  // namespace fusee::formats
