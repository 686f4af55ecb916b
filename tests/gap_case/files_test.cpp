// A case from memory is the case of the same files in a folder.
#include "fusee/gap_case/files.h"

#include <gtest/gtest.h>

#include "fixture.h"

namespace fusee {
namespace {

using Texts = fixtures::CaseFolder;

gap_case::CaseTexts texts_of(const std::filesystem::path& folder) {
    gap_case::CaseTexts texts;
    for (const std::string& name : gap_case::case_template_files()) texts[name] = core::read_file(folder / name);
    return texts;
}

TEST_F(Texts, GiveTheCaseOfTheirFolder) {
    const gap_case::CaseTexts texts = texts_of(folder_);
    const gap_case::Case of_folder = gap_case::read_case(folder_), of_texts = gap_case::read_case(gap_case::CaseFiles("small", texts));
    EXPECT_EQ(of_texts.name, "small");
    EXPECT_EQ(of_texts.sha256, of_folder.sha256);
    EXPECT_EQ(of_texts.remarks, of_folder.remarks);
    ASSERT_EQ(of_texts.rows.size(), of_folder.rows.size());
    EXPECT_EQ(gap_case::row_texts(of_texts, of_texts.rows), gap_case::row_texts(of_folder, of_folder.rows));
    EXPECT_EQ(gap_case::read_inputs(of_texts, gap_case::CaseFiles("small", texts)).size(), of_folder.rows.size());
}

TEST_F(Texts, AreRefusedWithFileLineAndColumn) {
    gap_case::CaseTexts texts = texts_of(folder_);
    texts["dead_band.csv"] = "cocontraction_Nm,q_low_rad,q_high_rad\n0.5,-0.3,east\n";
    try {
        (void)gap_case::read_case(gap_case::CaseFiles("small", texts));
        FAIL() << "accepted";
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.field(), "small/dead_band.csv:2:10: q_high_rad");
    }
    texts.erase("dead_band.csv");
    EXPECT_THROW((void)gap_case::read_case(gap_case::CaseFiles("small", texts)), core::InvalidInput);
    texts.erase("case.toml");
    EXPECT_THROW((void)gap_case::read_case(gap_case::CaseFiles("small", texts)), core::IoError);
}

TEST_F(Texts, OfATemplateAreTheFilesThatItWrites) {
    const gap_case::CaseTexts texts = gap_case::case_template_texts(template_);
    std::vector<std::string> names = gap_case::case_template_files(), found;
    std::sort(names.begin(), names.end());
    for (const auto& [name, text] : texts) found.push_back(name);
    EXPECT_EQ(found, names);
    EXPECT_EQ(texts.at("case.toml"), text("case.toml"));
}

TEST_F(Texts, ColumnsAreNamedAsInTheFile) {
    const gap_case::Rows rows = gap_case::read_case(folder_).rows;
    const std::vector<gap_case::Column> columns = gap_case::columns_of(rows, gap_case::Experiment::kJointStiffness);
    ASSERT_EQ(columns.size(), 4u);
    EXPECT_EQ(columns[1].name, "phase");
    EXPECT_EQ(std::get<std::vector<std::string>>(columns[1].cells).front(), "load+");
    EXPECT_EQ(columns[3].name, "q_rad");
    EXPECT_EQ(std::get<std::vector<double>>(columns[3].cells).size(), rows.joint_stiffness.size());
    EXPECT_EQ(std::get<std::vector<double>>(columns[3].cells).back(), rows.joint_stiffness.back().q);
    EXPECT_TRUE(gap_case::columns_of({}, gap_case::Experiment::kLog).empty());
}

}  // namespace
}  // namespace fusee
