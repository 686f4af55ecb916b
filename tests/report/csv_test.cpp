#include <gtest/gtest.h>

#include <sstream>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "report/fixture.h"

namespace fusee::report {
namespace {

class SpringsCsv : public ::testing::Test {
protected:
    core::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "springs.csv";
};

TEST_F(SpringsCsv, ColumnsRowsAndNumbersSurviveBitForBit) {
    const LinearLaw law;
    write_springs_csv(path_, law, 200);
    std::istringstream lines(core::read_file(path_));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "tau_Nm,theta_rad,f_se_Nm,f_pe_Nm,s_Nm_per_rad,p_Nm_per_rad,u_se_J,u_pe_J,t");
    const auto expected = spring::sample_by_load(law, 200);
    std::size_t row = 0;
    for (; std::getline(lines, line); ++row) {
        ASSERT_LT(row, expected.size());
        std::istringstream cells(line);
        std::string cell;
        std::vector<double> v;
        while (std::getline(cells, cell, ',')) v.push_back(std::stod(cell));
        const spring::LawPoint& p = expected[row];
        EXPECT_EQ(v, (std::vector<double>{p.tau, p.theta, p.f_se, p.f_pe, p.s, p.p, p.u_se, p.u_pe, p.transmission()}));
    }
    EXPECT_EQ(row, 200u);
}

TEST_F(SpringsCsv, RefusesFewRowsAndAMissingFolder) {
    EXPECT_THROW(write_springs_csv(path_, LinearLaw(), 199), core::InvalidInput);
    EXPECT_THROW(write_springs_csv(path_.parent_path() / "no" / "such.csv", LinearLaw(), 200), core::IoError);
}

}  // namespace
}  // namespace fusee::report
