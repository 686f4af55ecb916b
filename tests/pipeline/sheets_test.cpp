#include <fmt/format.h>

#include "fusee/batch/batch.h"
#include "fusee/exchange/part_file.h"
#include "pipeline/fixture.h"

namespace fusee::pipeline {
namespace {

class Sheets : public fixtures::TempFolder {
protected:
    [[nodiscard]] batch::MakeResult made(const std::string& formats, const std::string& out) const {
        const std::string text = fixtures::with_keys(core::read_file(fixtures::shipped("pnrvsa")),
                                                     {{"outputs.formats", formats}, {"outputs.pair", "false"}, {"outputs.plate", "false"}});
        return batch::make(profile::read_profile(write("pnrvsa.toml", text)), {.out = folder_ / out});
    }
};

TEST_F(Sheets, ShowTheNumbersOfThePartFile) {
    const batch::MakeResult result = made(R"(["stl", "drawing", "pdf"])", "out");
    ASSERT_TRUE(result.made);
    for (const char* name : {"k_se", "k_pe"}) {
        const exchange::PartFile part = exchange::read_part_file(result.folder / (std::string(name) + ".json"));
        const std::string svg = core::read_file(result.folder / (std::string(name) + "_drawing_2.svg"));
        for (const exchange::TargetRow* row : {&part.target.front(), &part.target.back()}) {
            EXPECT_NE(svg.find(fmt::format(">{:.3f}<", row->arm_mm)), std::string::npos) << name;
            EXPECT_NE(svg.find(fmt::format(">{:.2f}<", row->load)), std::string::npos) << name;
            EXPECT_NE(svg.find(fmt::format(">{:.4f}<", 1e-3 * row->arm_mm * row->load)), std::string::npos) << name;
        }
        EXPECT_NE(svg.find(part.provenance), std::string::npos);
        for (const exchange::FileEntry& file : part.files) EXPECT_EQ(file.name.find("drawing"), std::string::npos);  // carries no law
    }
}

TEST_F(Sheets, AreTheSameFromRunToRunAndOnlyWhereAskedFor) {
    const batch::MakeResult first = made(R"(["drawing", "pdf"])", "first"), second = made(R"(["drawing", "pdf"])", "second"),
                            none = made(R"(["stl"])", "none");
    ASSERT_TRUE(first.made && second.made && none.made);
    for (const char* name : {"k_se_drawing.svg", "k_se_drawing.pdf", "k_pe_drawing.svg", "k_pe_drawing.pdf"}) {
        EXPECT_EQ(core::read_file(first.folder / name), core::read_file(second.folder / name)) << name;
        EXPECT_FALSE(fixtures::fs::exists(none.folder / name)) << name;
    }
}

}  // namespace
}  // namespace fusee::pipeline
