#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "app/run.h"

// fusee check: on profiles, on meshes, for one process and for all.
namespace fusee::app {
namespace {

using Json = nlohmann::json;

class Check : public Program {
protected:
    static std::string pnrvsa() { return "'" + fixtures::shipped("pnrvsa").string() + "'"; }
    /// A cube of 10 mm as text; `height` may spoil it.
    std::string cube(const std::string& name, double height = 10.0) const {
        const std::string h = std::to_string(height);
        write(name, "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 " + h + "\nv 10 0 " + h + "\nv 10 10 " + h + "\nv 0 10 " + h +
                        "\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
        return name;
    }
};

TEST_F(Check, AProfileAsMakeFindsItAndNoFile) {
    const Ended checked = run("check " + pnrvsa());
    EXPECT_EQ(checked.code, 0) << checked.all();
    expect_words(checked.out,
                 {"pnrvsa by fdm: can be made: 0 errors (must be changed)", " rules passed", "[process] and [[limits]] of the profile"});
    EXPECT_EQ(checked.out.find("not judged"), std::string::npos) << "the shipped design states all its data";
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Check, ARequiredChangeEndsWith1) {
    const Ended checked = run("check " + pnrvsa() + " --process laser");
    EXPECT_EQ(checked.code, 1);
    expect_words(checked.err, {"pnrvsa by laser: cannot be made as it is", "error: stack.boss", "nearest feasible", "defaults of laser"});
}

TEST_F(Check, AllProcessesInOneTable) {
    const Ended checked = run("check " + pnrvsa() + " --process all --json");
    EXPECT_EQ(checked.code, 0) << "printing is possible";
    const Json j = result_of(checked);
    ASSERT_EQ(j.at("processes").size(), 7u);
    for (const Json& p : j.at("processes")) {
        ASSERT_EQ(p.at("parts").size(), 2u) << p.at("process");
        EXPECT_EQ(p.at("not_judged"), p.at("rules").at("not_judged"));
        EXPECT_EQ(p.at("not_judged").get<int>(),
                  p.at("parts").at(0).at("not_judged").get<int>() + p.at("parts").at(1).at("not_judged").get<int>());
        for (const Json& part : p.at("parts"))
            EXPECT_EQ(part.at("errors").get<int>() > 0, part.at("binding").is_object() && part.at("binding").at("severity") == "error");
        EXPECT_EQ(p.at("own").get<bool>(), p.at("process") == "fdm");
    }
    const Ended one = run("check " + pnrvsa() + " --json");
    EXPECT_EQ(result_of(one).at("processes").at(0), j.at("processes").at(0)) << "the table's own row is the check";
}

TEST_F(Check, TheTableOfProcessesHasAColumnOfWhatWasNotJudged) {
    const Ended checked = run("check " + pnrvsa() + " --process all");
    EXPECT_EQ(checked.out.rfind("process  part       errors warnings not judged  binding rule", 0), 0u) << checked.out;
}

/// A rim has no groove that a plate could be too thin for.
TEST_F(Check, ARollersRimByEachProcess) {
    const Ended checked = run("check '" + fixtures::shipped("examples/roller_follower").string() + "' --process all");
    EXPECT_EQ(checked.code, 0) << checked.all();
    for (const char* word : {"nan", "stack.groove_width"}) EXPECT_EQ(checked.out.find(word), std::string::npos) << checked.out;
}

TEST_F(Check, LimitsOfAnotherProcessAreLeftOutAndNamed) {
    write("t.toml", core::read_file(fixtures::shipped("pnrvsa")) +
                        "\n[[limits]]\nrule = \"process.wall\"\nrequired_mm = 0.4\nreason = \"coupon\"\n"
                        "\n[[limits]]\nrule = \"cable.fleet\"\nreview_deg = 3\nreason = \"ferrule\"\n");
    expect_words(run("check t.toml --process sla").all(), {"left out: process.wall required_mm = 0.4"});
    EXPECT_EQ(run("check t.toml --process sla").all().find("left out: cable"), std::string::npos);
    EXPECT_EQ(run("check t.toml").all().find("left out"), std::string::npos);
}

TEST_F(Check, AMeshAndWhereInColours) {
    const Ended good = run("check " + cube("good.obj") + " --process fdm");
    EXPECT_EQ(good.code, 0) << good.all();
    expect_words(good.out, {"good by fdm: can be made", "12 triangles, 10.00 x 10.00 x 10.00 mm"});
    const Ended thin = run("check " + cube("thin.obj", 0.5) + " --process fdm --out shown");
    EXPECT_EQ(thin.code, 1) << thin.all();
    expect_words(thin.err, {"error: mesh.wall", "measured 0.5 mm, allowed at least 0.8 mm", "thin_check.3mf"});
    EXPECT_TRUE(fs::exists(folder_ / "shown" / "thin_check.3mf"));
    const Json j = result_of(run("check thin.obj --process all --json"));
    EXPECT_EQ(j.at("processes").size(), 7u);
    EXPECT_TRUE(j.at("makeable").get<bool>()) << "resin holds 0.5 mm";
}

TEST_F(Check, AMeshByTheMachineOfAProfile) {
    cube("thin.obj", 0.5);
    write("t.toml", fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "process.min_wall_mm", "0.4"));
    const Ended own = run("check thin.obj --profile t.toml");
    EXPECT_EQ(own.code, 0) << own.all();
    expect_words(own.out, {"thin by fdm: can be made", "[process] of the profile"});
    EXPECT_EQ(run("check thin.obj --profile t.toml --process laser").code, 1)
        << "what is stated for the printer does not hold for the laser";
}

TEST_F(Check, AMeshByLimitsOfItsOwn) {
    cube("thin.obj", 0.5);
    write("ours.toml", "[[limits]]\nrule = \"mesh.wall\"\nrequired_mm = 0.4\nreview_mm = 0.6\nreason = \"coupon\"\n");
    const Ended ours = run("check thin.obj --process fdm --limits ours.toml");
    EXPECT_EQ(ours.code, 0) << ours.all();
    expect_words(ours.out, {"warning: mesh.wall", "allowed at least 0.6 mm", "instead of 0.8 mm: coupon", "[[limits]] of ours.toml"});
    const Json j = result_of(run("check thin.obj --process fdm --limits ours.toml --json"));
    const Json& findings = j.at("processes").at(0).at("parts").at(0).at("findings");
    const auto wall = std::find_if(findings.begin(), findings.end(), [](const Json& f) { return f.at("rule") == "mesh.wall"; });
    ASSERT_NE(wall, findings.end());
    EXPECT_EQ(wall->at("overridden").at(0).at("reason"), "coupon");
    const auto refused = [&](const std::string& text, std::initializer_list<std::string> words) {
        write("bad.toml", text);
        const Ended ended = run("check thin.obj --process fdm --limits bad.toml");
        EXPECT_EQ(ended.code, 2) << ended.all();
        expect_words(ended.err, words);
    };
    refused("[[limits]]\nrule = \"mesh.wal\"\nrequired_mm = 0.4\nreason = \"x\"\n", {"bad.toml:2:8: limits.rule", "mesh.wall"});
    refused("[[limits]]\nrule = \"process.wall\"\nrequired_mm = 0.4\nreason = \"x\"\n", {"unknown rule \"process.wall\""});
    refused("[[limits]]\nrule = \"mesh.wall\"\nrequired_mm = 0.4\n", {"limits.reason", "missing"});
    refused("[process]\nkind = \"fdm\"\n", {"bad.toml:1:2: process", "has no meaning here"});
    refused("", {"bad.toml", "limits", "missing"});
    EXPECT_EQ(run("check " + pnrvsa() + " --limits ours.toml").code, 2) << "a profile has its own";
}

/// An OBJ names files of materials: none is opened, neither one with a secret nor a pipe that never ends.
TEST_F(Check, AMeshReadsNoOtherFile) {
    write("secret.txt", "token hunter2\n");
    ASSERT_EQ(std::system(("mkfifo '" + (folder_ / "pipe").string() + "'").c_str()), 0);
    const std::string cube_text = core::read_file(folder_ / cube("cube.obj"));
    for (const char* file : {"secret.txt", "pipe", "/dev/zero", "/etc/hostname", "missing", "."}) {
        write("evil.obj", std::string("mtllib ") + file + "\nusemtl token\n" + cube_text);
        const Ended ended = run("check evil.obj --process fdm");
        EXPECT_EQ(ended.code, 0) << file << ended.all();
        EXPECT_EQ(ended.all().find("hunter2"), std::string::npos) << ended.all();
    }
}

TEST_F(Check, OnlyARegularFileIsAMesh) {
    ASSERT_EQ(
        std::system(
            ("cd '" + folder_.string() + "' && mkfifo a.stl b.toml && mkdir c.obj && ln -s /dev/zero d.step && ln -s a.stl e.3mf").c_str()),
        0);
    for (const char* file : {"a.stl --process fdm", "b.toml", "c.obj --process fdm", "d.step --process fdm", "e.3mf --process fdm"}) {
        const Ended ended = run(std::string("check ") + file);
        EXPECT_EQ(ended.code, 2) << file << ended.all();
        expect_words(ended.err, {"regular file"});
    }
}

/// What would turn the line around, or colour it, is shown; it becomes no name of a file.
TEST_F(Check, NamesAreShownAsTheyAre) {
    const std::string rlo = "\xE2\x80\xAE", name = "a" + rlo + "lts\x1b[31m.obj";
    fs::rename(folder_ / cube("a.obj"), folder_ / name);  // fusee writes no such name itself
    const Ended ended = run("check '" + name + "' --process fdm");
    EXPECT_EQ(ended.code, 0) << ended.all();
    expect_words(ended.out, {"a\\u202elts\\x1b[31m"});
    EXPECT_EQ(ended.all().find(rlo), std::string::npos);
    EXPECT_EQ(ended.all().find('\x1b'), std::string::npos);
    const Ended refused = run("check '" + name + "' --process fdm --out shown");
    EXPECT_EQ(refused.code, 2) << refused.all();
    expect_words(refused.err, {"a\\u202elts", "not seen"});
    EXPECT_FALSE(fs::exists(folder_ / "shown"));
}

/// Parts of other people, and the mesh that their own program exported of one.
TEST_F(Check, StepAndStlOfOnePartAgree) {
    const fs::path cases = fs::path(FUSEE_SOURCE_DIR) / "../shared/cases/mesh_step";
    if (!fs::exists(cases)) GTEST_SKIP() << cases << " is not here";
    static const std::set<std::string> kTopology{"mesh.manifold",          "mesh.closed",         "mesh.orientation",
                                                 "mesh.self_intersection", "mesh.flat_triangles", "mesh.bodies"};
    const auto faults = [&](const std::string& file) {
        const Ended ended = run("check '" + (cases / file).string() + "' --process fdm --json");
        std::set<std::string> found;
        for (const Json& f : result_of(ended).at("processes").at(0).at("parts").at(0).at("findings"))
            if (kTopology.contains(f.at("rule"))) found.insert(f.at("rule").get<std::string>());
        return found;
    };
    for (const char* file : {"motor_holder.step", "motor_holder.stl", "pulley.step"})
        EXPECT_EQ(faults(file), std::set<std::string>{}) << file;
}

TEST_F(Check, OneThreadOrThreeSayTheSame) {
    cube("a.obj");
    EXPECT_EQ(run("check a.obj --process mill --json -j 1").out, run("check a.obj --process mill --json -j 3").out);
}

TEST_F(Check, BadInputIsNamed) {
    const auto refused = [&](const std::string& arguments, std::initializer_list<std::string> words) {
        const Ended ended = run("check " + arguments);
        EXPECT_EQ(ended.code, 2) << arguments << ended.all();
        expect_words(ended.err, words);
    };
    refused("missing.toml", {"missing.toml"});
    refused("missing.stl --process fdm", {"missing.stl", "cannot be opened"});
    refused("notes.txt --process fdm", {"notes.txt", ".toml", ".stl"});
    refused(cube("a.obj"), {"--process", "missing"});
    refused("a.obj --process wax", {"wax"});
    refused(pnrvsa() + " --out shown", {"--out", "a mesh"});
    refused("a.obj --profile missing.toml", {"missing.toml"});
    refused("a.obj --profile '" + fixtures::shipped("relatives/series_elastic").string() + "'", {"--profile", "[process]"});
    write("b.stl", "solid x\nfacet normal 0 0 1\n");
    refused("b.stl --process fdm", {"b.stl", "endsolid"});
    write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    refused("line.obj --process fdm", {"line.obj"});
    write("file", "");
    refused("a.obj --process fdm --out file", {"file: is a file, not a folder"});
    refused("a.obj --process fdm --out file/x", {"file: is a file, not a folder"});
    refused(cube("far.obj", 1e10) + " --process fdm", {"far.obj", "1e+10 mm", "1e+09 mm"});
}

}  // namespace
}  // namespace fusee::app
