#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/csv.h"

// Tables as spreadsheets and instruments write them.
namespace fusee::core {
namespace {

const std::vector<CsvColumn> kLaw{{"angle_rad"}, {"series_Nm"}, {"parallel_Nm"}};
const std::vector<CsvColumn> kTests{{"side", CsvColumn::Kind::kText}, {"motor_torque_Nm"}, {"load_torque_Nm"}};

using Rows = std::vector<std::vector<double>>;

Rows law(const std::string& bytes, const CsvMapping& mapping = {}) {
    const CsvTable t = parse_csv(bytes, "t.csv", kLaw, {.mapping = mapping});
    return {t.numbers("angle_rad"), t.numbers("series_Nm"), t.numbers("parallel_Nm")};
}

std::string refusal(const std::string& bytes, const std::vector<CsvColumn>& columns = kLaw, const CsvMapping& mapping = {}) {
    try {
        (void)parse_csv(bytes, "t.csv", columns, {.mapping = mapping});
    } catch (const InputError& e) {
        return e.what();
    }
    return "none";
}

void expect_words(const std::string& text, std::initializer_list<std::string> words) {
    for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

std::string utf16(const std::string& ascii, bool little, bool mark) {
    std::string out = mark ? (little ? "\xFF\xFE" : "\xFE\xFF") : "";
    for (const char c : ascii) out += little ? std::string{c, '\0'} : std::string{'\0', c};
    return out;
}

const Rows kThree{{0.0, 0.5, 1.25}, {1.0, 1234.5, 2.0}, {0.125, 0.25, 0.375}};

struct Form {
    const char* name;
    std::string bytes;
};

TEST(CsvDialect, OneTableInEveryForm) {
    const std::string plain = "angle_rad,series_Nm,parallel_Nm\n0,1,0.125\n0.5,1234.5,0.25\n1.25,2,0.375\n";
    const std::vector<Form> forms{
        {"plain", plain},
        {"German", "angle_rad;series_Nm;parallel_Nm\r\n0;1;0,125\r\n0,5;1.234,5;0,25\r\n1,25;2;0,375\r\n"},
        {"French",
         "angle_rad;series_Nm;parallel_Nm\n0;1;0,125\n0,5;1\xC2\xA0"
         "234,5;0,25\n1,25;2;0,375\n"},
        {"thin blank",
         "angle_rad;series_Nm;parallel_Nm\n0;1;0,125\n0,5;1\xE2\x80\xAF"
         "234,5;0,25\n1,25;2;0,375\n"},
        {"Swiss", "angle_rad;series_Nm;parallel_Nm\n0;1;0.125\n0.5;1'234.5;0.25\n1.25;2;0.375\n"},
        {"English, quoted",
         "\"angle_rad\",\"series_Nm\",\"parallel_Nm\"\n\"0\",\"1\",\"0.125\"\n\"0.5\",\"1,234.5\",\"0.25\"\n\"1.25\",2,0.375\n"},
        {"tabs", "angle_rad\tseries_Nm\tparallel_Nm\n0\t1\t0,125\n0,5\t1234,5\t0,25\n1,25\t2\t0,375\n"},
        {"bars", "angle_rad|series_Nm|parallel_Nm\n0|1|0.125\n0.5|1234.5|0.25\n1.25|2|0.375\n"},
        {"blanks", "  angle_rad series_Nm   parallel_Nm\n  0   1  0.125\n  0.5 1234.5 0.25\n 1.25   2 0.375  \n"},
        {"trailing separators", "angle_rad;series_Nm;parallel_Nm;;\n0;1;0,125;;\n0,5;1234,5;0,25;;\n1,25;2;0,375;;\n;;;;\n"},
        {"another order, capitals, another column",
         "Nr.,PARALLEL_NM,Angle_Rad,series_nm\n1,0.125,0,1\n2,0.25,0.5,1234.5\n3,0.375,1.25,2\n"},
        {"units in brackets", "Angle (rad);Series [mNm];Parallel / N\xC2\xB7m\n0;1000;0,125\n0,5;1234500;0,25\n1,25;2000;0,375\n"},
        {"a row of units", "Angle;Series;Parallel\nrad;Nm;N mm\n0;1;125\n0,5;1234,5;250\n1,25;2;375\n"},
        {"a row of units in brackets", "angle\tseries\tparallel\n[rad]\t[Nm]\t[Nm]\n0\t1\t0.125\n0.5\t1234.5\t0.25\n1.25\t2\t0.375\n"},
        {"a preamble", "Instrument: T-500; serial 12\nDate;27.11.2026\n\n" + plain},
        {"sep=", "sep=;\r\nangle_rad;series_Nm;parallel_Nm\r\n0;1;0,125\r\n0,5;1234,5;0,25\r\n1,25;2;0,375\r\n"},
        {"a header behind a comment sign", "# angle_rad series_Nm parallel_Nm\n0 1 0.125\n0.5 1234.5 0.25\n1.25 2 0.375\n"},
        {"comments", "% made by a log\n// twice\n\"# thrice, in quotes\",,\n" + plain + "# end\n"},
        {"CR alone", "angle_rad,series_Nm,parallel_Nm\r0,1,0.125\r0.5,1234.5,0.25\r1.25,2,0.375\r"},
        {"UTF-16, little, marked", utf16(plain, true, true)},
        {"UTF-16, big, marked", utf16(plain, false, true)},
        {"UTF-16, little", utf16(plain, true, false)},
        {"a header in two lines", "\"angle\n(rad)\",series_Nm,\"parallel\n(Nm)\"\n0,1,0.125\n0.5,1234.5,0.25\n1.25,2,0.375\n"},
        {"a minus sign and exponents", "angle_rad,series_Nm,parallel_Nm\n0E0,+1,1.25e-1\n0.5,1.2345E3,0.25\n1.25,2,0.375\n"}};
    for (const Form& form : forms) {
        Rows read;
        EXPECT_NO_THROW(read = law(form.bytes)) << form.name << ": " << refusal(form.bytes);
        EXPECT_EQ(read, kThree) << form.name;
    }
}

TEST(CsvDialect, UnitsAreConverted) {
    const Rows read =
        law("Angle [\xC2\xB0];Series (N\xC2\xB7mm);Parallel in kgf\xC2\xB7"
            "cm\n180;1500;1\n");
    EXPECT_DOUBLE_EQ(read[0][0], std::acos(-1.0));
    EXPECT_DOUBLE_EQ(read[1][0], 1.5);
    EXPECT_DOUBLE_EQ(read[2][0], 0.0980665);
    EXPECT_DOUBLE_EQ(law("Angle [\xB0];series_mNm;parallel_Nm\n180;1500;1\n")[0][0], std::acos(-1.0)) << "Windows-1252";
    const CsvTable t = parse_csv("angle_deg,series_Nm,parallel_Nm\n57.29577951308232,1,1\n", "t.csv", kLaw);
    EXPECT_STREQ(t.fault(0, "angle_rad", "1", "less").what(), "t.csv:2:1: angle_deg: 57.2958, which is 1 as angle_rad (allowed: less)");
}

TEST(CsvDialect, SpellingsOfUnits) {
    for (const char* text : {"Nm", "N\xC2\xB7m", "N*m", "N m", "[Nm]", "(N.m)", "NM", "nm"})
        EXPECT_STREQ(find_measure_unit(text)->name, "Nm") << text;
    for (const char* text : {"deg", "\xC2\xB0", "degrees", "Grad", "Deg"}) EXPECT_STREQ(find_measure_unit(text)->name, "deg") << text;
    for (const char* text : {"lbf\xC2\xB7in", "in-lb", "lb-in", "in.lb"}) EXPECT_STREQ(find_measure_unit(text)->name, "lbfin") << text;
    for (const char* text : {"ft-lb", "lb-ft"}) EXPECT_STREQ(find_measure_unit(text)->name, "lbfft") << text;
    EXPECT_STREQ(find_measure_unit("N-mm")->name, "Nmm");
    EXPECT_STREQ(find_measure_unit("\xC2\xB5m")->name, "um");
    EXPECT_STREQ(find_measure_unit("\xCE\xBCm")->name, "um");
    EXPECT_STREQ(find_measure_unit("N/mm\xC2\xB2")->name, "N/mm2");
    EXPECT_STREQ(find_measure_unit("Nm_per_rad")->name, "Nm/rad");
    for (const char* text : {"mPa", "MNm", "furlong", "S", ""}) EXPECT_EQ(find_measure_unit(text), nullptr) << text;
}

TEST(CsvDialect, WhatReadsTwoWaysIsAskedWithBothReadings) {
    const std::string head = "angle_rad;series_Nm;parallel_Nm\n";
    expect_words(refusal(head + "0;1,234;2,345\n"), {"t.csv:2:3: series_Nm: '1,234' is 1.234 with a decimal comma, or 1234",
                                                     "--columns 'decimal=,' or --columns 'decimal=.'"});
    EXPECT_EQ(law(head + "0;1,234;2,345\n", CsvMapping::of({"decimal=,"}))[1][0], 1.234);
    EXPECT_EQ(law(head + "0;1,234;2,345\n", CsvMapping::of({"decimal=."}))[1][0], 1234.0);
    EXPECT_EQ(law(head + "0;1,234;0,345\n")[1][0], 1.234) << "another number tells";
    expect_words(refusal(head + "0,5;1.234;2\n"), {"'1.234' is 1.234 with a decimal point, or 1234"});
    expect_words(refusal(head + "0,5;0.5;2\n"), {"'0,5' has a decimal comma, '0.5' in line 2 a decimal point"});
    expect_words(
        refusal("angle_deg,Angle (rad),series_Nm,parallel_Nm\n0,0,1,1\n"),
        {"'angle_deg' and 'Angle (rad)' both fit angle_rad", "--columns 'angle_rad=angle_deg' or --columns 'angle_rad=Angle (rad)'"});
    expect_words(refusal("Angle,series_Nm,parallel_Nm\n0,1,1\n"),
                 {"'Angle' has no unit", "'angle_rad=Angle in rad'", "'angle_rad=Angle in deg'"});
    expect_words(refusal("angle_rad,series_Nm,parallel_Nm\ndeg,Nm,Nm\n0,1,1\n"), {"the header says rad, the row of units deg"});
}

TEST(CsvDialect, AUnitThatIsNotKnownOrOfAnotherQuantityIsRefusedWithTheList) {
    expect_words(refusal("Angle [furlong],series_Nm,parallel_Nm\n0,1,1\n"), {"'furlong'", "rad, mrad, deg, turn"});
    expect_words(refusal("angle_rad,Series [N],parallel_Nm\n0,1,1\n"), {"'Series [N]' is in N", "Nm, mNm"});
    expect_words(refusal("angle_rad,series_Nm,parallel_Nm\n0,1,1\n", kLaw, CsvMapping::of({"angle_rad=angle_rad in ell"})),
                 {"'ell'", "rad, mrad"});
}

TEST(CsvDialect, ForeignHeadersAreShownWithTheLinesToWriteAndReadByThem) {
    const std::string csv = "Seite;Motormoment [mNm];Lastmoment [Nm]\nlinks;500;0,7\n";
    const std::string said = refusal(csv, kTests);
    expect_words(said, {"'side,motor_torque_Nm,load_torque_Nm' (missing)", "--columns 'side=Seite'",
                        "--columns 'motor_torque_Nm=Motormoment [mNm]'", "--columns 'load_torque_Nm=Lastmoment [Nm]'"});
    CsvMapping mapping = CsvMapping::of({"side=Seite", "motor_torque_Nm=Motormoment [mNm]", "load_torque_Nm=Lastmoment [Nm] in mNm"});
    const CsvTable t = parse_csv(csv, "t.csv", kTests, {.mapping = mapping});
    EXPECT_EQ(t.texts("side")[0], "links");
    EXPECT_DOUBLE_EQ(t.numbers("motor_torque_Nm")[0], 0.5);
    EXPECT_DOUBLE_EQ(t.numbers("load_torque_Nm")[0], 0.7e-3) << "the user's unit counts";
    EXPECT_TRUE(t.unit_is_told("load_torque_Nm"));
    EXPECT_FALSE(t.unit_is_told("motor_torque_Nm"));
    CsvMapping in_toml;
    in_toml.table = "columns";
    expect_words(refusal(csv, kTests, in_toml), {"columns = { side = \"Seite\", motor_torque_Nm = \"Motormoment [mNm]\""});
    for (const char* wrong : {"side", "=x", "decimal=;", "side="}) EXPECT_THROW((void)CsvMapping::of({wrong}), InvalidInput) << wrong;
    EXPECT_THROW((void)CsvMapping::of({"side=a", "side=b"}), InvalidInput);
}

TEST(CsvDialect, DecimalCommasBetweenCommasAreNamed) {
    expect_words(refusal("angle_rad,series_Nm,parallel_Nm\n0,1,0,5,0,7\n"),
                 {"t.csv:2:7: row: '5'", "with decimal commas the cells need semicolons"});
}

TEST(CsvDialect, AQuoteThatDoesNotCloseIsNamed) {
    expect_words(refusal("side,motor_torque_Nm,load_torque_Nm\n\"a,1,2\nb,1,2\n", kTests), {"t.csv:2:1: row", "a quote that is closed"});
    const CsvTable t = parse_csv("side,motor_torque_Nm,load_torque_Nm\n\"a; b,\n c\",1,2\nd,3,4\n", "t.csv", kTests);
    EXPECT_EQ(t.texts("side"), (std::vector<std::string>{"a; b,\n c", "d"}));
    EXPECT_EQ(t.line(1), 4U);
}

TEST(CsvDialect, AQuestionNamesTheLineOfEachAnswer) {
    const CsvTable t = parse_csv("angle_rad,series_Nm,parallel_Nm\n90,1,1\n", "t.csv", kLaw);
    EXPECT_STREQ(
        t.question(0, "angle_rad", "deg", "more than two turns").what(),
        "t.csv:2:1: angle_rad: 90; more than two turns (allowed: are these degrees? Say which: --columns 'angle_rad=angle_rad in deg' "
        "or --columns "
        "'angle_rad=angle_rad in rad')");
}

TEST(CsvDialect, FitsAndHeader) {
    EXPECT_TRUE(csv_fits("Angle [deg];Series [Nm]\n1;2\n", {{"angle_rad"}, {"series_Nm"}}));
    EXPECT_FALSE(csv_fits("Angle [deg];Series [Nm]\n1;2\n", kLaw));
    EXPECT_FALSE(csv_fits("", kLaw));
    EXPECT_EQ(csv_header("# a\n\"one\";two;three\n1;2;3\n"), (std::vector<std::string>{"one", "two", "three"}));
    EXPECT_EQ(csv_header("name,rig.x\na,1\n"), (std::vector<std::string>{"name", "rig.x"}));
}

// The form is found in the first 300 kB; a later row that contradicts it is refused.
TEST(CsvDialect, ALaterRowIsReadInTheSameForm) {
    std::string csv = "angle_rad;series_Nm;parallel_Nm\n";
    for (int i = 0; i < 30'000; ++i) csv += "0,5;1,5;2,25\n";
    EXPECT_EQ(law(csv)[2].back(), 2.25);
    expect_words(refusal(csv + "0.5;1;2\n"), {"t.csv:30002:1: angle_rad: '0.5'", "decimal comma"});
}

// A slip in --columns would leave the mapping without effect; [columns] of a profile speaks of all of its files.
TEST(CsvDialect, ANameOfNoColumnInTheOptionIsRefused) {
    const std::string csv = "angle_rad,series_Nm,parallel_Nm\n0,1,0.125\n";
    CsvMapping slip = CsvMapping::of({"serie_Nm=Feder"});
    expect_words(refusal(csv, kLaw, slip), {"--columns: 'serie_Nm'", "a column of t.csv", "angle_rad,series_Nm,parallel_Nm"});
    slip.table = "columns";
    EXPECT_EQ(refusal(csv, kLaw, slip), "none");
}

}  // namespace
}  // namespace fusee::core
