#include "fusee/core/csv.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/file.h"

namespace fusee::core {
namespace {

const std::vector<CsvColumn> kColumns{{"side", CsvColumn::Kind::kText},
                                      {"torque_Nm"},
                                      {"note", CsvColumn::Kind::kText, false},
                                      {"length_m", CsvColumn::Kind::kNumber, false}};

std::string csv_refusal(const std::string& bytes, const CsvOptions& options = {}) {
    try {
        (void)parse_csv(bytes, "t.csv", kColumns, options);
    } catch (const InputError& e) {
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
    EXPECT_EQ(csv_refusal(head + "a,,1\n"), "t.csv:2:3: torque_Nm: (missing) (allowed: a finite number in every row)");
    EXPECT_EQ(csv_refusal(head + "a\n"), "t.csv:2:2: torque_Nm: (missing) (allowed: a finite number in every row)");
    EXPECT_EQ(csv_refusal(head + "a,1\n"), "t.csv:2:4: length_m: (missing) (allowed: a finite number in every row)");
    EXPECT_EQ(csv_refusal(head + "a,1,1\n , 1,1\n"), "t.csv:3:2: side: (missing) (allowed: a text in every row)");
    EXPECT_EQ(csv_refusal(head + "\"a\"b,1,1\n"), "t.csv:2:1: side: '\"a\"b' (allowed: a text without quotation marks)");
    for (const std::string wrong : {"nan", "inf", "-inf", "1e999", "1 Nm", "0x10", "+-1", "1,5e", "one", "--1", "1.0.0"})
        EXPECT_NE(csv_refusal(head + "a," + wrong + ",1\n").find("t.csv:2:"), std::string::npos) << wrong;
    EXPECT_EQ(csv_refusal(head + "a,1,1,2\n"), "t.csv:2:7: row: '2' (allowed: three columns)");
    EXPECT_EQ(csv_refusal(head + "a,\x1B[2J,1\n"), "t.csv:2:3: torque_Nm: '\\x1b[2J' (allowed: a finite number with a decimal point)");
    const std::string shown = csv_refusal(head + "a," + std::string(100'000, 'x') + ",1\n");
    EXPECT_NE(shown.find("xxx... (100000 characters)'"), std::string::npos);
    EXPECT_LT(shown.size(), 200u);
}

TEST(Csv, ReportsAllBadCellsAtOnce) {
    EXPECT_EQ(csv_refusal("side,torque_Nm,length_m\na,,1\nb,2,x\nc\nd,4,4,4\n,nan,5\nf,6,6\n"),
              "6 mistakes:\n"
              "t.csv:2:3: torque_Nm: (missing) (allowed: a finite number in every row)\n"
              "t.csv:3:5: length_m: 'x' (allowed: a finite number with a decimal point)\n"
              "t.csv:4:2: torque_Nm: (missing) (allowed: a finite number in every row)\n"
              "t.csv:5:7: row: '4' (allowed: three columns)\n"
              "t.csv:6:1: side: (missing) (allowed: a text in every row)\n"
              "t.csv:6:2: torque_Nm: 'nan' (allowed: a finite number with a decimal point)");
}

TEST(Csv, OfManyBadCellsTheFirstTwentyAreReported) {
    std::string csv = "side,torque_Nm\n";
    for (int i = 0; i < 500; ++i) csv += "a,\n";
    const std::string all = csv_refusal(csv + "b,1\n");
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 21);
    EXPECT_TRUE(
        all.ends_with("t.csv:21:3: torque_Nm: (missing) (allowed: a finite number in every row)\nt.csv: and 480 more (allowed: none)"))
        << all;
}

TEST(Csv, ThinsByAConstantStrideAndChecksWhatItLeavesOut) {
    std::string csv = "side,torque_Nm\n";
    for (int i = 0; i < 21; ++i) csv += "a" + std::to_string(i) + "," + std::to_string(i) + "\n";
    const CsvOptions few{.most_kept = 6};
    const CsvTable t = parse_csv(csv, "t.csv", kColumns, few);
    EXPECT_EQ(t.rows_read(), 21u);
    EXPECT_EQ(t.stride(), 4u);
    EXPECT_EQ(t.numbers("torque_Nm"), (std::vector<double>{0, 4, 8, 12, 16, 20}));
    EXPECT_EQ(t.texts("side"), (std::vector<std::string>{"a0", "a4", "a8", "a12", "a16", "a20"}));
    EXPECT_EQ(t.line(1), 6u);
    EXPECT_EQ(csv_refusal(csv + "a,x\n", few), "t.csv:23:3: torque_Nm: 'x' (allowed: a finite number with a decimal point)");
    EXPECT_EQ(parse_csv(csv, "t.csv", kColumns, {.most_kept = 21}).stride(), 1u);
}

TEST(Csv, RowsBeyondASpanAreCheckedOnly) {
    const CsvOptions span{.span_column = "torque_Nm", .longest_span = 2.0};
    const std::string csv = "side,torque_Nm\na,5\nb,6\nc,7\nd,8\ne,7\n";
    const CsvTable t = parse_csv(csv, "t.csv", kColumns, span);
    EXPECT_EQ(t.numbers("torque_Nm"), (std::vector<double>{5, 6, 7, 7}));
    EXPECT_EQ(t.rows_beyond_span(), 1u);
    EXPECT_EQ(t.rows_read(), 5u);
    EXPECT_EQ(csv_refusal(csv + "f,9\ng,\n", span), "t.csv:8:3: torque_Nm: (missing) (allowed: a finite number in every row)");
}

TEST(Csv, AnEmptyCellMayBeAllowed) {
    const CsvTable t =
        parse_csv("torque_Nm,side\n,a\n2,b\n", "t.csv", {{"side", CsvColumn::Kind::kText}, {.name = "torque_Nm", .gaps = true}});
    EXPECT_TRUE(std::isnan(t.numbers("torque_Nm")[0]));
    EXPECT_EQ(t.numbers("torque_Nm")[1], 2.0);
}

TEST(Csv, RefusesHeaders) {
    EXPECT_EQ(csv_refusal(""), "t.csv:1:1: header: (missing) (allowed: 'side,torque_Nm,note,length_m')");
    EXPECT_EQ(csv_refusal("# nothing\n\n"), "t.csv:1:1: header: (missing) (allowed: 'side,torque_Nm,note,length_m')");
    EXPECT_EQ(csv_refusal("torque_Nm,x\n1,2\n"),
              "t.csv:1:12: header: 'side' (missing) (allowed: 'side,torque_Nm,note,length_m'; in the file: 'torque_Nm', 'x'; "
              "where one of them is meant: --columns 'side=x')");
    EXPECT_EQ(csv_refusal("side,torque_Nm,side\n"), "t.csv:1:16: header: 'side' (allowed: every column once)");
}

TEST(Csv, RefusesTooFewAndTooManyRows) {
    EXPECT_EQ(csv_refusal("side,torque_Nm\n"), "t.csv:1:1: rows: 0 (allowed: at least 1)");
    EXPECT_EQ(csv_refusal("side,torque_Nm\na,1\n", {.least_rows = 2}), "t.csv:2:1: rows: 1 (allowed: at least 2)");
    EXPECT_EQ(csv_refusal("side,torque_Nm\na,1\na,2\na,3\n", {.most_rows = 2}), "t.csv:4:1: rows: more (allowed: at most 2)");
    EXPECT_EQ(csv_refusal("side,torque_Nm\na,1\na,2\n", {.most_rows = 2}), "none");
}

TEST(Csv, ReadsAFileUpToItsLimit) {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / ("fusee_csv_" + std::to_string(::getpid()) + ".csv");
    write_file(path, "side,torque_Nm\na,1\n");
    EXPECT_EQ(read_csv(path, kColumns).rows(), 1u);
    EXPECT_THROW((void)read_csv(path, kColumns, {.largest_bytes = 10}), IoError);
    std::filesystem::remove(path);
    EXPECT_THROW((void)read_csv(path, kColumns), IoError);
}

/// A file is read in pieces that cut lines anywhere.
TEST(Csv, PiecesOfAFileGiveWhatTheWholeGives) {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / ("fusee_csv_" + std::to_string(::getpid()) + ".csv");
    std::string csv = "side,torque_Nm\r\n";
    for (int i = 0; i < 30'000; ++i) csv += "left," + std::to_string(i) + (i % 3 == 0 ? "\r\n" : "\n");
    csv += "end,-1";
    write_file(path, csv);
    Sha256 hash;
    const CsvTable read = read_csv(path, kColumns, {}, [&hash](std::string_view bytes) { hash.add(bytes); });
    const CsvTable whole = parse_csv(csv, "t.csv", kColumns);
    EXPECT_EQ(read.numbers("torque_Nm"), whole.numbers("torque_Nm"));
    EXPECT_EQ(read.texts("side"), whole.texts("side"));
    EXPECT_EQ(read.line(30'000), 30'002u);
    EXPECT_EQ(hash.hex(), sha256_hex(csv));
    std::filesystem::remove(path);
    EXPECT_EQ(csv_refusal("side,torque_Nm\n" + std::string(2'000'000, 'x')), "t.csv:2:1: line: longer (allowed: at most 1000000 bytes)");
}

}  // namespace
}  // namespace fusee::core
