#include "app/run.h"
#include "fusee/core/provenance.h"

namespace fusee::app {
namespace {

TEST_F(Program, SaysItsVersion) {
    const Ended version = run("--version");
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out.find("fusee " + std::string(core::version()) + " ("), 0u) << version.out;
    EXPECT_EQ(version.out, run("--version").out);
    EXPECT_EQ(std::count(version.out.begin(), version.out.end(), '\n'), 1);
}

TEST_F(Program, HelpOfEveryCommandHasAnExample) {
    const Ended help = run("--help");
    EXPECT_EQ(help.code, 0);
    expect_words(help.out, {"Example:\n  fusee make", "make", "keys", "rules", "completion", "--version"});
    for (const std::string command : {"make", "explain", "keys", "rules", "completion", "man"}) {
        const Ended of_command = run(command + " --help");
        EXPECT_EQ(of_command.code, 0);
        expect_words(of_command.out, {"Usage: fusee " + command, "Example:\n  ", "fusee " + command});
    }
}

TEST_F(Program, HelpIsAlsoAWord) {
    EXPECT_EQ(run("").out, run("--help").out);
    EXPECT_EQ(run("").code, 0);
    EXPECT_EQ(run("help").out, run("--help").out);
    EXPECT_EQ(run("help make").out, run("make --help").out);
    EXPECT_EQ(run("help blind make").out, run("blind make --help").out);
    EXPECT_EQ(run("-V").out, run("--version").out);
}

TEST_F(Program, APlaceInAFileIsShownWithItsLine) {
    const std::string toml = core::read_file(fixtures::shipped("pnrvsa"));
    write("t.toml", "name = \"t\"\n[rig]\n  capstan_radius_mm = = 3\n");
    const std::string shown = "\n    3 |   capstan_radius_mm = = 3\n      |                       ^\n";
    for (const char* command : {"make t.toml", "check t.toml", "simulate t.toml"}) expect_words(run(command).err, {"t.toml:3:23: ", shown});
    write("p/t.toml", fixtures::with_key(toml, "cable.diameter_mm", "-1"));
    expect_words(run("check p/t.toml").err, {" | diameter_mm = -1", "^\n"});
    write("long.toml", "a = [" + std::string(500, ' ') + "%]\n");
    expect_words(run("check long.toml").err, {"\n    1 |  ", "%]\n", " ^\n"});
}

TEST_F(Program, ListsKeysAndRules) {
    expect_words(run("keys").out, {"\n[k_pe.path]\n", "\n  gear_friction = (required)\n    mu: ", "\n    allowed: a number, 0 to 0.95\n"});
    expect_words(run("keys --markdown").out, {"`gear_friction`", "`[k_pe.path]`", "| key | allowed | default | meaning |"});
    expect_words(run("rules").out, {"cable.bend_ratio", "collision.printed_throat", "required_mm", "source: "});
    const std::string names = run("keys --names").out;
    expect_words(names, {"name\n", "\nk_pe.path.kind\n"});
    EXPECT_EQ(names.find('|'), std::string::npos);
}

TEST_F(Program, WrongArgumentsAreNamedAndEndWith2) {
    const std::pair<const char*, std::string> cases[] = {{"mkae", "mkae"},
                                                         {"help mkae", "did you mean make?"},
                                                         {"--json", "command is required"},
                                                         {"make", "at least one profile"},
                                                         {"init", "Example: fusee init my_joint.toml\n"},
                                                         {"diagnose", "Example: fusee diagnose bench/monday"},
                                                         {"diagnose nowhere --out on", "nowhere: there is no such folder: a case is"},
                                                         {"diagnose . --out on", "has no case.toml: a case is a folder with"},
                                                         {"init x.toml --kind spring --law x --yes", "such as --from 0 --to 90"},
                                                         {"make --bar x.toml", "--bar"},
                                                         {"--bar", "--bar"},
                                                         {"make x.toml --via foo", "foo"},
                                                         {"make x.toml --jobs -1", "--jobs"},
                                                         {"make x.toml -j two", "--jobs"},
                                                         {"completion", "shell"},
                                                         {"completion tcsh", "tcsh"},
                                                         {"rules xyzzy", "xyzzy"},
                                                         {"make -q -v x.toml", "--verbose"}};
    for (const auto& [arguments, word] : cases) {
        const Ended wrong = run(arguments);
        EXPECT_EQ(wrong.code, 2) << arguments;
        EXPECT_TRUE(wrong.out.empty() || std::string_view(arguments) == "--json") << arguments;
        expect_words(wrong.err, {word});
    }
}

TEST_F(Program, MakesADesignAndSaysSo) {
    const Ended made = run("make '" + fixtures::shipped("first_prototype").string() + "' --out 'my cams'");
    EXPECT_EQ(made.code, 0) << made.all();
    expect_words(made.out, {"first_prototype.toml", "made", "my cams/first_prototype/", "of the files 0.0"});
    EXPECT_TRUE(fs::exists(folder_ / "my cams" / "first_prototype" / "k_pe.stl"));
}

TEST_F(Program, AnImpossibleDesignEndsWith1AndWritesNothing) {
    write("t.toml", fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "law.start_torque_Nm", "0.2"));
    const Ended refused = run("make t.toml");
    EXPECT_EQ(refused.code, 1);
    EXPECT_EQ(refused.out, "");
    expect_words(refused.err,
                 {"t.toml  refused", "error: law.transmission", "measured 0.2 Nm, allowed at least 0.265", "law.start_torque_Nm = 0.2"});
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Program, SeveralProfilesEndInOneTable) {
    write("p/a.toml", fixtures::with_key(core::read_file(folder_ / quick("pnrvsa")), "name", "\"a\""));
    write("p/b.toml", "name = 3\n");
    const Ended several = run("make p missing.toml -j 2");
    EXPECT_EQ(several.code, 2);
    expect_words(several.err, {"p/a.toml      made", "p/b.toml      bad input", "missing.toml  bad input", "p/b.toml:1:", "make 3/3"});
    EXPECT_TRUE(fs::exists(folder_ / "out" / "a" / "report.html"));
}

}  // namespace
}  // namespace fusee::app
