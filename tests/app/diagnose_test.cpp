#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "app/run.h"

// Gap cases from the command line: `diagnose`, `predict`.
namespace fusee::app {
namespace {

class Gap : public Program {
protected:
    /// A case of the shipped joint with break-aways alone, whose friction is `factor` times the nominal one.
    void SetUp() override {
        Program::SetUp();
        ASSERT_EQ(run("case-template '" + fixtures::shipped("pnrvsa").string() + "' --out case").code, 0);
        const std::string toml = core::read_file(folder_ / "case" / "case.toml");
        write("case/case.toml", toml.substr(0, toml.find("[experiments]")) + "[experiments]\nbreakaway = \"breakaway.csv\"\n");
        inputs_ = core::read_file(folder_ / "case" / "breakaway.csv");
        write("case/breakaway.csv", filled(1.0));
        write("inputs/breakaway.csv", inputs_);
    }
    [[nodiscard]] std::string filled(double factor) const {
        std::istringstream rows(inputs_);
        std::string csv, line;
        std::getline(rows, csv);
        for (int i = 0; std::getline(rows, line); ++i) {
            const bool backdrive = line.find("backdrive") != std::string::npos;
            const double motor = std::stod(line.substr(line.find(',', line.find(',') + 1) + 1));
            const double mu = 0.28 * factor * (1.0 + 0.02 * (i % 4 - 1.5));  // repeats scatter
            csv += fmt::format("\n{}{}", line, motor / (backdrive ? 1.0 - mu : 1.0 + mu));
        }
        return csv + "\n";
    }

    std::string inputs_;
};

TEST_F(Gap, DiagnosesACaseAndPredictsOtherInputs) {
    const Ended found = run("diagnose case --out 'my bench/result' --jobs 1");
    ASSERT_EQ(found.code, 0) << found.all();
    expect_words(found.out, {"case: ", "written: my bench/result/diagnosis.html, diagnosis.json"});
    const std::string json = core::read_file(folder_ / "my bench" / "result" / "diagnosis.json");
    EXPECT_EQ(nlohmann::json::parse(json).at("verdict"), "inconclusive") << json;  // break-away alone
    EXPECT_EQ(run("diagnose case --out again --jobs 2").code, 0);
    EXPECT_EQ(core::read_file(folder_ / "again" / "diagnosis.json"), json);
    EXPECT_EQ(fixtures::contents(folder_ / "again").size(), 2u);

    const Ended nominal = run("predict case --inputs inputs --out nominal");
    ASSERT_EQ(nominal.code, 0) << nominal.all();
    expect_words(nominal.out, {"96 rows predicted by the nominal model", "written: nominal/"});
    EXPECT_EQ(run("predict case --effects again/diagnosis.json --inputs inputs --out predicted").code, 0);
    EXPECT_EQ(fixtures::contents(folder_ / "predicted").size(), 1u);
    const std::string rows = core::read_file(folder_ / "nominal" / "breakaway.csv");
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 97);
    EXPECT_EQ(rows.find(",\n"), std::string::npos) << "an empty cell";
    write("case/breakaway.csv", inputs_);  // an empty template says what to expect
    expect_words(run("predict case --out expected").out, {"96 rows predicted by the nominal model"});
    EXPECT_EQ(core::read_file(folder_ / "expected" / "breakaway.csv"), rows);
}

TEST_F(Gap, DiagnosesASimulatorOfTheUsersOwn) {
    fs::copy(fs::path(FUSEE_SOURCE_DIR) / "profiles/models/cam_spring", folder_ / "cam");
    const Ended found = run("diagnose cam --out found --jobs 2");
    ASSERT_EQ(found.code, 0) << found.all();
    expect_words(found.out, {"cam: The rig has an effect that the model lacks: lift_m.", "remedy: Measure it"});
    const std::string json = core::read_file(folder_ / "found" / "diagnosis.json");
    EXPECT_EQ(run("diagnose cam --out again --jobs 1").code, 0);
    EXPECT_EQ(core::read_file(folder_ / "again" / "diagnosis.json"), json);
    const Ended predicted = run("predict cam --effects found/diagnosis.json --out expected");
    expect_words(predicted.out, {"600 rows predicted by the model with 1 effect"});
    EXPECT_EQ(fixtures::contents(folder_ / "expected").size(), 3u);
    expect_words(run("diagnose cam --out twin --write-mjcf rig").err, {"--write-mjcf", "this one has no joint"});

    const std::string whole = core::read_file(folder_ / "cam" / "case.toml");  // logs alone, with the model of another folder
    const std::size_t logged = whole.find("[experiments"), figures = whole.find("[parameters]");
    write("logs/case.toml", whole.substr(logged, figures - logged));
    for (const char* file : {"slow.csv", "fast.csv", "half.csv"}) fs::copy(folder_ / "cam" / file, folder_ / "logs" / file);
    const Ended elsewhere = run("diagnose logs --model cam/case.toml --out with_model");
    expect_words(elsewhere.out, {"logs: The rig has an effect that the model lacks: lift_m."});
    EXPECT_EQ(run("predict logs --model cam/case.toml --effects found/diagnosis.json --out with_effects").code, 0);
    EXPECT_EQ(core::read_file(folder_ / "with_effects" / "slow.csv"), core::read_file(folder_ / "expected" / "slow.csv"));
    expect_words(run("diagnose logs --model logs/case.toml --out none").err, {"logs/case.toml", "model.command", "missing"});

    expect_words(run("diagnose cam --against case --out on").err, {"--against", "case: a joint's case, and cam: a simulator's"});
    fs::copy(folder_ / "cam", folder_ / "tuesday");
    const std::string toml = core::read_file(folder_ / "tuesday" / "case.toml");
    write("tuesday/case.toml", std::regex_replace(toml, std::regex("preload_m"), "zero_m"));
    expect_words(run("diagnose cam --against tuesday --out on").err, {"tuesday/case.toml", "another model, without", "preload_m"});

    write("cam/model.py", "import sys\nprint('out of order', file=sys.stderr)\nsys.exit(3)\n");
    const Ended dead = run("diagnose cam --out dead");
    EXPECT_EQ(dead.code, 2) << dead.all();
    expect_words(dead.err, {"cam/case.toml: model.command", "exit code 3", "out of order", "to repeat it: cd cam"});
    EXPECT_FALSE(fs::exists(folder_ / "dead"));
    EXPECT_EQ(run("predict cam --out dead").code, 2);
    fs::rename(folder_ / "cam", folder_ / "my cam");
    expect_words(run("diagnose 'my cam' --out dead").err, {"to repeat it: cd 'my cam' && python3 model.py < "});
}

TEST_F(Gap, PredictsASubsystemCaseIntoANewFolder) {
    write("cams/case.toml", "[bench]\nkind = \"cam_joint\"\n[experiments]\npull = \"pull_a.csv\"\n");
    write("cams/law_a.csv", "q_rad,torque_Nm\n-0.3,-30\n0.3,30\n");
    write("cams/pull_a.csv", "t_s,q_rad,torque_Nm\n0,0,0.5\n1,0.1,10.5\n2,0.2,20.5\n3,0.1,10.5\n4,0,0.5\n");
    const Ended own = run("predict cams --out 'new/of its own'");  // without --inputs: the case's files
    ASSERT_EQ(own.code, 0) << own.all();
    expect_words(own.out, {"5 rows predicted by the nominal model", "written: new/of its own/"});
    // The law, and the sensor's zero of the case's rows; that zeros are small is one more row of the fit, which takes 1e-6 of it.
    const auto torque_at = [&](const fs::path& file, const std::string& row) {
        const std::string rows = core::read_file(folder_ / file);
        const std::size_t at = rows.find("\n" + row + ",");
        EXPECT_NE(at, std::string::npos) << rows;
        return at == std::string::npos ? 0.0 : std::stod(rows.substr(at + row.size() + 2));
    };
    EXPECT_NEAR(torque_at("new/of its own/pull_a.csv", "2,0.2"), 20.5, 1e-5);
    write("others/pull_b.csv", "t_s,q_rad\n0,0\n1,0.1\n");
    write("others/law_b.csv", "q_rad,torque_Nm\n-0.3,-60\n0.3,60\n");
    ASSERT_EQ(run("predict cams --inputs others --out predicted").code, 0);
    EXPECT_NEAR(torque_at("predicted/pull_b.csv", "1,0.1"), 20.5, 1e-5);
}

TEST_F(Gap, WritesTheMeasurementThatADiagnosisAsksFor) {
    ASSERT_EQ(run("diagnose case --out found").code, 0);
    const auto found = nlohmann::json::parse(core::read_file(folder_ / "found" / "diagnosis.json"));
    const auto asked = found.at("next").at(0);
    const std::string experiment = asked.at("experiment");
    const Ended done = run("case-template case --next found/diagnosis.json --out tuesday");
    ASSERT_EQ(done.code, 0) << done.all();
    expect_words(done.out, {asked.at("text").get<std::string>(), "an empty case with", "written: tuesday/"});
    EXPECT_EQ(fixtures::contents(folder_ / "tuesday").size(), 4u);  // BENCH.md, case.toml, springs, one sheet
    const std::string toml = core::read_file(folder_ / "tuesday" / "case.toml");
    EXPECT_EQ(toml.substr(toml.find("[experiments]")),
              fmt::format("[experiments] # remove what was not measured\n{0} = \"{0}.csv\"\n", experiment));
    expect_words(core::read_file(folder_ / "tuesday" / "BENCH.md"),
                 {"The diagnosis asks for", asked.at("text").get<std::string>(), "## " + experiment,
                  fmt::format("`{0} = [\"{0}_next.csv\"]`", experiment)});  // the case has break-aways alone

    // Measured and named beside the first file, it is part of the next diagnosis.
    ASSERT_EQ(run("predict tuesday --out expected").code, 0);
    write("case/" + experiment + "_next.csv", core::read_file(folder_ / "expected" / (experiment + ".csv")));
    const std::string first = core::read_file(folder_ / "case" / "case.toml");
    write("case/case.toml", first + (experiment == "breakaway" ? "" : experiment + " = [\"" + experiment + "_next.csv\"]\n"));
    const Ended again = run("diagnose case --out again");
    EXPECT_EQ(again.code, 0) << again.all();

    const auto expect_refused = [&](const std::string& arguments, std::initializer_list<std::string> words) {
        const Ended refused = run(arguments);
        EXPECT_EQ(refused.code, 2) << refused.all();
        expect_words(refused.err, words);
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    };
    expect_refused("case-template case --next found/diagnosis.json --out out", {"case_sha256", "diagnose the case as it is now"});
    write("case/case.toml", first);
    expect_refused("case-template case --next found/diagnosis.json --out ./case", {"--out", "a folder other than that of the case"});
    nlohmann::json none = found;
    none["next"] = nlohmann::json::array();
    write("none.json", none.dump());
    expect_refused("case-template case --next none.json --out out", {"none.json: next", "no measurement"});
    none["next"] = nlohmann::json::array({asked});
    none["next"][0]["text"] = "Weigh the joint: 1.00 bit, 3 min.";
    write("none.json", none.dump());
    expect_refused("case-template case --next none.json --out out", {"none.json: next", "diagnose the case again"});
}

TEST_F(Gap, WritesTheDiagnosedRigForMujoco) {
    write("d.json", R"({"effects": [{"id": "joint.coulomb", "side": "none", "parameter": {"value": 0.07}}]})");
    const Ended done = run("predict case --effects d.json --inputs inputs --out rows --write-mjcf 'to simulate/rig'");
    ASSERT_EQ(done.code, 0) << done.all();
    expect_words(done.out, {"96 rows predicted", "model for MuJoCo: to simulate/rig/"});
    EXPECT_EQ(fixtures::contents(folder_ / "rows").size(), 1u);
    EXPECT_EQ(fixtures::contents(folder_ / "to simulate" / "rig").size(), 4u);
    const std::string model = core::read_file(folder_ / "to simulate" / "rig" / "joint.xml");
    EXPECT_NE(model.find("case case, joint.coulomb 0.07 Nm"), std::string::npos) << model;
    const auto laws = nlohmann::json::parse(core::read_file(folder_ / "to simulate" / "rig" / "laws.json"));
    ASSERT_EQ(run("predict case --inputs inputs --out rows2 --write-mjcf nominal").code, 0);
    const auto nominal = nlohmann::json::parse(core::read_file(folder_ / "nominal" / "laws.json"));
    const auto friction = [](const nlohmann::json& twin) { return twin.at("joint").at("friction_Nm").get<double>(); };
    EXPECT_NEAR(friction(laws) - friction(nominal), 0.07, 1e-12);  // that of a good bearing is the nominal one
    EXPECT_EQ(nominal.at("agonist").at("k_se"), laws.at("agonist").at("k_se"));

    ASSERT_EQ(run("diagnose case --out found --write-mjcf found/rig").code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "found" / "rig" / "joint_twin.py"));
    for (const char* arguments :
         {"predict case --inputs inputs --out same --write-mjcf ./same/", "diagnose case --out same --write-mjcf same"}) {
        const Ended refused = run(arguments);
        EXPECT_EQ(refused.code, 2) << refused.all();
        expect_words(refused.err, {"--write-mjcf", "a folder other than --out"});
        EXPECT_FALSE(fs::exists(folder_ / "same"));
    }
    write("cams/case.toml", "[bench]\nkind = \"cam_joint\"\n[experiments]\npull = \"pull_a.csv\"\n");
    write("cams/pull_a.csv", "t_s,q_rad,torque_Nm\n0,0,0.5\n");
    expect_words(run("predict cams --out same --write-mjcf rig").err, {"--write-mjcf", "this one has no joint"});
}

TEST_F(Gap, RefusesBadInputAndWritesNothing) {
    const auto expect_refused = [&](const std::string& arguments, std::initializer_list<std::string> words) {
        const Ended refused = run(arguments);
        EXPECT_EQ(refused.code, 2) << refused.all();
        expect_words(refused.err, words);
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    };
    expect_refused("diagnose case", {"--out"});
    expect_refused("diagnose missing --out out", {"missing: there is no such folder", "case-template"});
    expect_refused("predict case --out case", {"--out", "a folder other than"});
    expect_refused("predict case --inputs inputs --out inputs", {"--out", "a folder other than"});
    expect_refused("predict case --inputs inputs --out case", {"--out", "a folder other than"});
    expect_refused("predict case --inputs nowhere --out out", {"nowhere", "none of the case's files"});
    write("d.json", R"({"effects": [{"id": "no.effect", "parameter": {"value": 1}}]})");
    expect_refused("predict case --effects d.json --inputs inputs --out out", {"no.effect"});
    write("d.json", "{");
    expect_refused("predict case --effects d.json --inputs inputs --out out", {"d.json", "not valid JSON"});
    const std::pair<std::string, std::string> bad[] = {
        {R"({"effects": [{"id": "se.radius", "side": "both", "parameter": {"value": -0.02}}]})", "-0.012 to 0.012 m"},
        {R"({"effects": [{"id": "gear.coulomb", "side": "both", "parameter": {"value": 1e400}}]})", "d.json:1:"},
        {R"({"effects": [], "efects": []})", "efects: unknown key"},
        {std::string(100'000, '['), "nested 65 deep"}};
    for (const auto& [text, words] : bad) {
        write("d.json", text);
        expect_refused("predict case --effects d.json --inputs inputs --out out", {"d.json", words});
    }
    write("case/breakaway.csv", inputs_.substr(0, inputs_.find('\n')) + "\nagonist,drive,1,0.7\nagonist,backdrive,1,1.4\n");
    expect_refused("diagnose case --out out", {"case: experiments: 2 rows (allowed: at least 4 rows in all)"});
    write("case/breakaway.csv", inputs_);
    expect_refused("diagnose case --out out", {"case/breakaway.csv:2:", "load_torque_Nm: 96 of 96 rows have no number"});
    for (const char* file : {"nominal_springs.csv", "breakaway.csv"}) fs::remove(folder_ / "case" / file);
    expect_refused("diagnose case --out out", {"2 mistakes", "rig.springs: nominal_springs.csv not found: restore it\n",
                                               "experiments.breakaway: breakaway.csv not found"});
}

}  // namespace
}  // namespace fusee::app
