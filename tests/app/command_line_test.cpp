#include "app/run.h"

namespace fusee::app {
namespace {

using Json = nlohmann::json;

TEST_F(Program, AWrongWordIsAnsweredWithTheNearOne) {
    const std::pair<const char*, std::string> cases[] = {
        {"mkae x.toml", "mkae: there is no such command; did you mean make?"},
        {"make --jbos 2", "--jbos: there is no such option; did you mean --jobs"},
        {"make --vai=cgal", "--vai=cgal: there is no such option; did you mean --via?"},
        {"check x.stl --process fmd", "did you mean fdm?"},
        {"make x.toml --via openscd", "did you mean openscad?"},
        {"explain bend_rato", "did you mean bend_ratio"},
        {"explain gear.colomb", "did you mean gear.coulomb"},
        {"keys lawz", "did you mean law"},
        {"rules cabel", "did you mean cable"},
        {"blind mkae", "mkae: there is no such command; did you mean make?"},
        {"hlep make", "hlep: there is no such command; did you mean help?"},
        {"--color never mkae x.toml", "mkae: there is no such command; did you mean make?\nMore"},
        {"make x.toml --xyzzy", "--xyzzy: there is no such option"},
        {"budget x.toml --wanted 2,5", "2,5 (allowed: a number with a decimal point"},
        {"budget x.toml --wanted 0", "0 (allowed: a number, 0.01 to 100)"},
    };
    for (const auto& [arguments, words] : cases) {
        const Ended wrong = run(arguments);
        EXPECT_EQ(wrong.code, 2) << arguments;
        expect_words(wrong.err, {words});
    }
    EXPECT_EQ(run("xyzzy").err, "xyzzy: there is no such command\nMore: fusee --help\n");
}

TEST_F(Program, AHelpSaysInWordsWhatAValueMayBe) {
    expect_words(run("make --help").out, {"Arguments:", "[cgal, openscad; default cgal]", "--jobs NUMBER", "0 to 1024; default 0]"});
    expect_words(run("batch --help").out, {"[not with --merge, --shard, --slurm]", "with --slurm]"});
    for (const char* line : {"--help", "make --help", "batch --help", "diagnose --help", "springs --help"}) {
        const std::string help = run(line).out;
        for (const char* jargon : {"UINT", "FLOAT", "TEXT:", "REQUIRED", "Excludes:", "Needs:", "SUBCOMMAND"})
            EXPECT_EQ(help.find(jargon), std::string::npos) << line << ": " << jargon;
    }
}

TEST_F(Program, WrongChoicesOfAProfileAreAnsweredWithTheNearOne) {
    const std::string toml = core::read_file(fixtures::shipped("pnrvsa"));
    write("t.toml", fixtures::with_key(toml, "process.kind", "\"fmd\""));
    expect_words(run("make t.toml").err, {"process.kind", "did you mean \"fdm\"?"});
    write("t.toml", fixtures::with_key(toml, "outputs.formats", "[\"stll\"]"));
    expect_words(run("make t.toml").err, {"outputs.formats", "did you mean \"stl\""});
}

TEST_F(Program, OptionsOfEveryCommandWorkBeforeAndAfterIt) {
    EXPECT_EQ(run("--json keys law").out, run("keys law --json").out);
    EXPECT_EQ(run("--json blind make").out, run("blind make --json").out);
    const std::string red = "\x1b[1;31m";
    write("t.toml", "name = 3\n");
    for (const char* line : {"--color always check t.toml", "check t.toml --color always"}) expect_words(run(line).err, {red + "fusee"});
    EXPECT_EQ(run("check t.toml").err.find(red), std::string::npos) << "no terminal";
    EXPECT_EQ(run("check t.toml --color never").err.find(red), std::string::npos);
    EXPECT_EQ(run("check t.toml --color blue").code, 2);
}

/// On a terminal: `script` runs the command in one.
TEST_F(Program, ATerminalGetsColourUnlessNoColorIsSet) {
    if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "script is not installed";
    write("t.toml", "name = 3\n");
    const auto on_terminal = [this](const std::string& before, const std::string& arguments) {
        const std::string out = (folder_ / ".typescript").string();
        (void)std::system(("cd '" + folder_.string() + "' && " + before + " TERM=xterm script -qec \"'" FUSEE_PROGRAM "' " + arguments +
                           "\" /dev/null >'" + out + "' </dev/null")
                              .c_str());
        return core::read_file(out);
    };
    EXPECT_NE(on_terminal("", "check t.toml").find("\x1b[1;31mfusee"), std::string::npos);
    EXPECT_EQ(on_terminal("NO_COLOR=1", "check t.toml").find('\x1b'), std::string::npos);
    for (const char* command : {"keys law", "rules cable", "explain law.kind"}) {
        std::istringstream lines(on_terminal("NO_COLOR=1 COLUMNS=60", command));
        std::size_t count = 0;
        for (std::string line; std::getline(lines, line); ++count)
            EXPECT_LE(line.size(), 61u) << command << ": " << line;  // with the carriage return
        EXPECT_GT(count, 5u) << command;
    }
    write("t.toml", "name = 3  # the number of a joint is no name: a name begins with a letter or a figure\n");
    std::string narrow = on_terminal("NO_COLOR=1 COLUMNS=60", "check t.toml");
    std::erase(narrow, '\r');
    expect_words(narrow, {"    1 | name = 3  # the number of a joint is no name\n      |        ^\n"});
}

TEST_F(Program, QuietSaysNothingAndVerboseSaysMore) {
    const std::string profile = quick("first_prototype");
    const Ended quiet = run("make -q " + profile);
    EXPECT_EQ(quiet.code, 0);
    EXPECT_EQ(quiet.all(), "");
    const Ended verbose = run("-v make " + profile);
    EXPECT_EQ(verbose.code, 0);
    expect_words(verbose.err, {" s  spring law\n", " s  part files and read-back\n", " s  reports\n", " s in all\n"});
    std::istringstream stages(run("make " + profile).err);  // none without a terminal, unless the machine is busy: ten seconds are slow
    for (std::string line; std::getline(stages, line);) EXPECT_TRUE(line.starts_with("make ")) << line;
    EXPECT_NE(run("-q make missing.toml").err, "") << "errors stay";
}

TEST_F(Program, BadInputIsOneObjectWithItsPlaceAndALineOnStandardError) {
    write("t.toml", fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "cable.diameter_mm", "-1"));
    for (const char* command : {"make", "check", "simulate", "budget", "coupons"}) {
        const Ended wrong = run(std::string(command) + " t.toml --json");
        EXPECT_EQ(wrong.code, 2) << command;
        const Json json = Json::parse(wrong.out);
        EXPECT_EQ(json.at("command"), command);
        EXPECT_EQ(json.at("verdict"), "bad input");
        const Json& mistake = json.at("error").at("mistakes").at(0);
        EXPECT_EQ(mistake.at("file"), "t.toml") << wrong.out;
        EXPECT_GT(mistake.at("line").get<int>(), 1);
        EXPECT_EQ(mistake.at("field"), "cable.diameter_mm");
        EXPECT_EQ(mistake.at("value"), "-1");
        EXPECT_FALSE(mistake.at("allowed").get<std::string>().empty());
        expect_words(wrong.err, {"t.toml:", "cable.diameter_mm"});
    }
    const Json line = Json::parse(run("make x.toml --jobs two --json").out);
    EXPECT_EQ(line.at("error").at("mistakes").at(0).at("field"), "--jobs");
}

TEST_F(Program, TheResultOfMakeIsTheSameAtEachRun) {
    const std::string line = "make --quiet --json " + quick("first_prototype");
    const Ended made = run(line);
    EXPECT_EQ(made.err, "");
    const Json design = result_of(made).at("designs").at(0);
    EXPECT_EQ(design.at("outcome"), "made");
    EXPECT_EQ(design.at("folder"), "out/first_prototype");
    EXPECT_GT(design.at("findings").size(), 50u);
    EXPECT_EQ(run(line).out, made.out);
}

TEST_F(Program, TheHelpGroupsTheCommands) {
    const std::string help = run("--help").out;
    const std::size_t make = help.find("\nMake a part:\n  init "), test = help.find("\nTest a joint:\n"), look = help.find("\nLook up:\n");
    EXPECT_LT(make, test);
    EXPECT_LT(test, look);
    EXPECT_NE(look, std::string::npos);
}

}  // namespace
}  // namespace fusee::app
