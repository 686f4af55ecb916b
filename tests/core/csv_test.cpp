#include "fusee/core/csv.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "fusee/core/file.h"

namespace fusee::core {
namespace {

const std::vector<CsvColumn> kColumns{{"side", CsvColumn::Kind::kText},
                                      {"torque_Nm"},
                                      {"note", CsvColumn::Kind::kText, false},
                                      {"length_m", CsvColumn::Kind::kNumber, false}};

std::string refusal(const std::string& bytes, const CsvOptions& options = {}) {
    try {
        (void)parse_csv(bytes, "t.csv", kColumns, options);
    } catch (const InvalidInput& e) {
        return e.what();
    }
    return "none";
}

TEST(Csv, ColumnsInAnyOrderExtraOnesPassedOver) {
    const CsvTable t = parse_csv("x,torque_Nm,side\n,1.5,left\nfive,-2e-3,right\n", "t.csv", kColumns);
    EXPECT_EQ(t.rows(), 2u);
    EXPECT_EQ(t.numbers("torque_Nm"), (std::vector<double>{1.5, -2e-3}));
    EXPECT_EQ(t.texts("side"), (std::vector<std::string>{"left", "right"}));
    EXPECT_FALSE(t.has("note"));
    EXPECT_FALSE(t.has("x"));
}

TEST(Csv, PassesOverMarkCommentsBlankLinesSpacesAndForeignLineEnds) {
    const CsvTable t =
        parse_csv("\xEF\xBB\xBF# bench\r\n\r\n side ,\ttorque_Nm, note\r\n a b , +1 ,z\r\n  \t\r\n#,\r\nc,2,y", "t.csv", kColumns);
    EXPECT_EQ(t.texts("side"), (std::vector<std::string>{"a b", "c"}));
    EXPECT_EQ(t.numbers("torque_Nm"), (std::vector<double>{1, 2}));
    EXPECT_EQ(t.texts("note"), (std::vector<std::string>{"z", "y"}));
    EXPECT_EQ(t.fault(1, "torque_Nm", "2", "less").what(), std::string("t.csv:7:3: torque_Nm: 2 (allowed: less)"));
}

TEST(Csv, RefusesCellsAndNamesThePlace) {
    const std::string head = "side,torque_Nm,length_m\n";
    EXPECT_EQ(refusal(head + "a,,1\n"), "t.csv:2:3: torque_Nm: (missing) (allowed: a finite number in every row)");
    EXPECT_EQ(refusal(head + "a\n"), "t.csv:2:2: torque_Nm: (missing) (allowed: a finite number in every row)");
    EXPECT_EQ(refusal(head + "a,1\n"), "t.csv:2:4: length_m: (missing) (allowed: a finite number in every row)");
    EXPECT_EQ(refusal(head + "a,1,1\n , 1,1\n"), "t.csv:3:2: side: (missing) (allowed: a text in every row)");
    EXPECT_EQ(refusal(head + "\"a\",1,1\n"), "t.csv:2:1: side: '\"a\"' (allowed: a text without quotation marks)");
    for (const std::string wrong : {"nan", "inf", "-inf", "1e999", "1 Nm", "0x10", "+-1", "1,5e", "one", "--1", "1.0.0"})
        EXPECT_NE(refusal(head + "a," + wrong + ",1\n").find("t.csv:2:"), std::string::npos) << wrong;
    EXPECT_EQ(refusal(head + "a,1,1,2\n"), "t.csv:2:7: row: '2' (allowed: three columns)");
    const std::string shown = refusal(head + "a," + std::string(100'000, 'x') + ",1\n");
    EXPECT_NE(shown.find("xxx...'"), std::string::npos);
    EXPECT_LT(shown.size(), 200u);
}

TEST(Csv, RefusesHeaders) {
    EXPECT_EQ(refusal(""), "t.csv:1:1: header: (missing) (allowed: 'side,torque_Nm,note,length_m')");
    EXPECT_EQ(refusal("# nothing\n\n"), "t.csv:1:1: header: (missing) (allowed: 'side,torque_Nm,note,length_m')");
    EXPECT_EQ(refusal("torque_Nm,x\n1,2\n"), "t.csv:1:12: header: 'side' (missing) (allowed: 'side,torque_Nm,note,length_m')");
    EXPECT_EQ(refusal("side,torque_Nm,side\n"), "t.csv:1:16: header: 'side' (allowed: every column once)");
    EXPECT_EQ(refusal("side,x,torque_Nm\na,1,1\n", {.extra_columns = false}),
              "t.csv:1:6: header: 'x' (allowed: 'side,torque_Nm,note,length_m')");
}

TEST(Csv, RefusesTooFewAndTooManyRows) {
    EXPECT_EQ(refusal("side,torque_Nm\n"), "t.csv:1:1: rows: 0 (allowed: at least 1)");
    EXPECT_EQ(refusal("side,torque_Nm\na,1\n", {.least_rows = 2}), "t.csv:2:1: rows: 1 (allowed: at least 2)");
    EXPECT_EQ(refusal("side,torque_Nm\na,1\na,2\na,3\n", {.most_rows = 2}), "t.csv:4:1: rows: more (allowed: at most 2)");
    EXPECT_EQ(refusal("side,torque_Nm\na,1\na,2\n", {.most_rows = 2}), "none");
}

TEST(Csv, ReadsAFileUpToItsLimit) {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / ("fusee_csv_" + std::to_string(::getpid()) + ".csv");
    write_file(path, "side,torque_Nm\na,1\n");
    EXPECT_EQ(read_csv(path, kColumns).rows(), 1u);
    EXPECT_THROW((void)read_csv(path, kColumns, {.largest_bytes = 10}), IoError);
    std::filesystem::remove(path);
    EXPECT_THROW((void)read_csv(path, kColumns), IoError);
}

}  // namespace
}  // namespace fusee::core
