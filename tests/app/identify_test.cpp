#include "app/run.h"

// Gear friction from break-away tests, as a user sees it.
namespace fusee::app {
namespace {

constexpr const char* kHead = "side,direction,motor_torque_Nm,load_torque_Nm\n";

TEST_F(Program, IdentifiesTheShippedExample) {
    const fs::path csv = fs::path(FUSEE_SOURCE_DIR) / "profiles" / "examples" / "break_away.csv";
    const Ended found = run("identify '" + csv.string() + "' --out 'my bench'");
    EXPECT_EQ(found.code, 0) << found.all();
    EXPECT_EQ(found.err, "");
    expect_words(found.out, {"agonist backdrive", "not distinguishable from 0", "[rig]\ngear_friction = 0.28",
                             "my bench/identify-break_away/identification.html"});
    const fs::path folder = folder_ / "my bench" / "identify-break_away";
    expect_words(core::read_file(folder / "identification.json"), {"\"gear_friction\": 0.28"});
    expect_words(core::read_file(folder / "identification.html"), {"data-page=\"identification\"", "\"line_curve\":"});
    const std::string page = core::read_file(folder / "identification.html");
    EXPECT_EQ(run("identify '" + csv.string() + "' --out 'my bench'").code, 0);
    EXPECT_EQ(core::read_file(folder / "identification.html"), page);
}

TEST_F(Program, RowsThatAreNoGearEndWith1) {
    write("t.csv", std::string(kHead) + "a,backdrive,0.2,0.1\na,backdrive,0.5,0.25\na,backdrive,1,0.5\n");
    const Ended none = run("identify t.csv");
    EXPECT_EQ(none.code, 1) << none.all();
    expect_words(none.out, {"is outside the range of a gear", "wrong side of the motor torque", "line 2, line 3, line 4"});
    EXPECT_TRUE(fs::exists(folder_ / "out" / "identify-t" / "identification.json"));
}

TEST_F(Program, IdentifyRefusesBadRowsAndWritesNothing) {
    const auto expect_refused = [&](const std::string& csv, std::initializer_list<std::string> words) {
        write("t.csv", csv);
        const Ended refused = run("identify t.csv");
        EXPECT_EQ(refused.code, 2) << refused.all();
        EXPECT_EQ(refused.out, "");
        expect_words(refused.err, words);
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    };
    const std::string head = kHead;
    expect_refused("", {"t.csv:1:1: header", "side,direction,motor_torque_Nm,load_torque_Nm"});
    expect_refused("side,direction,motor_torque_Nm\n", {"t.csv:1:31: header: 'load_torque_Nm' (missing)"});
    expect_refused(head + "a,up,1,2\n", {"t.csv:2:3: direction: 'up'", "drive or backdrive"});
    expect_refused(head + "a,drive,1,nan\n", {"t.csv:2:11: load_torque_Nm: 'nan'"});
    expect_refused(head + "a,drive,1,0.7\na,drive,1.2,0.8\n", {"rows: 2", "at least 3"});
    expect_refused(head + "a,drive,1,0.7\na,drive,1,0.8\na,drive,1,0.8\n", {"motor_torque_Nm: 1 in every row"});
    EXPECT_EQ(run("identify missing.csv").code, 2);
    EXPECT_EQ(run("identify /dev/zero").code, 2);
    EXPECT_EQ(run("identify").code, 2);
}

}  // namespace
}  // namespace fusee::app
