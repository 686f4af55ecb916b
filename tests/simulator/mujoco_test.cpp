#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "fusee/core/companion.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/simulator/process.h"
#include "simulator/fixture.h"

// Models that describe themselves, and the companion that does so for files of MuJoCo.
namespace fusee::simulator {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A program that describes a spring with friction, as another MuJoCo would, and answers for it.
const char* const kDescribing = R"py(
import json, sys
for line in sys.stdin:
    r = json.loads(line)
    if "describe" in r:
        assert sys.argv[1] == "spring.xml"
        print(json.dumps({"id": 0, "parameters": {"rate_N_per_m": {"nominal": 900.0, "tolerance": 0.05}, "friction_N": {"nominal": 0.0}, "rest_m": {"nominal": 0.0}},
            "effects": {"friction_N": {"frees": ["friction_N"], "usual": [1.0], "range": [0.0, 10.0], "meaning": "It rubs.", "remedy": "Oil it."}}}))
        continue
    assert r["outputs"] == ["force_N"]
    p = r["parameters"]
    print(json.dumps({"id": r["id"], "outputs": {"force_N": [p["rate_N_per_m"] * (x - p["rest_m"]) for x in r["inputs"]["x_m"]]}}))
)py";

class Described : public ::testing::Test {
protected:
    /// The case of a file spring.xml with these further lines.
    Case read(const std::string& parameters, const std::string& model = "command = [\"python3\", \"own.py\"]\nmjcf = \"spring.xml\"") {
        gap_case::CaseTexts texts = fixtures::pulled_spring();
        std::string& toml = texts["case.toml"];
        toml = "[model]\n" + model + "\n" + toml.substr(toml.find("\n\n[experiments"));
        toml = toml.substr(0, toml.find("[parameters]")) + parameters;
        for (const auto& [name, text] : texts) core::write_file(folder_.path() / name, text);
        core::write_file(folder_.path() / "own.py", kDescribing);
        core::write_file(folder_.path() / "spring.xml", "<mujoco/>");
        return read_case(folder_.path());
    }
    std::string error_of(const std::string& parameters, const std::string& model) {
        try {
            (void)read(parameters, model);
        } catch (const core::InputError& e) {
            return e.what();
        }
        return "";
    }
    core::TemporaryFolder folder_;
};

TEST_F(Described, FiguresAndEffectsNeedNoLineOfTheCase) {
    const Case own = read("");
    ASSERT_EQ(own.parameters.size(), 3u);
    EXPECT_EQ(own.parameters[0].unit, "N_per_m");
    EXPECT_DOUBLE_EQ(own.parameters[0].sigma, 45.0);
    ASSERT_EQ(own.effects.size(), 1u);
    EXPECT_EQ(own.effects[0].meaning, "It rubs.");
    const Simulated model(own, start_processes(own, 1));
    const inference::Outputs outputs = model.predict({{10.0}, {}}, inference::Extent::kAll);
    EXPECT_NEAR(outputs[0][5], 910.0 * own.experiments[0].runs[0].columns.at("x_m")[5], 1e-9);
}

TEST_F(Described, TheCaseMayStateThemOtherwise) {
    const Case own =
        read("[parameters]\nrate_N_per_m = {nominal = 1000.0}\nfriction_N = {tolerance_abs = 0.1}\nrest_m = {nominal = 0.001}\n");
    EXPECT_DOUBLE_EQ(own.parameters[0].nominal, 1000.0);
    EXPECT_DOUBLE_EQ(own.parameters[0].sigma, 0.0) << "no tolerance: exact";
    EXPECT_DOUBLE_EQ(own.parameters[1].sigma, 0.1);
    EXPECT_TRUE(own.effects.empty()) << "a figure with a tolerance is a cause by itself";
    const Case moved = read("[parameters]\nfriction_N = {nominal = 20.0}\n");
    EXPECT_TRUE(moved.effects.at(0).ranges[0].holds(20.0));
    const Case more = read("[effects.sag]\nfrees = [\"rest_m\"]\nusual = 0.001\nrange = [-1, 1]\nmeaning = \"It sags.\"\nremedy = \"-\"\n");
    ASSERT_EQ(more.effects.size(), 2u);
    EXPECT_EQ(more.effects[1].id, "sag");
    EXPECT_NE(read("").sha256, (core::write_file(folder_.path() / "spring.xml", "<mujoco> </mujoco>"), read_case(folder_.path()).sha256));
}

TEST_F(Described, MistakesAreNamed) {
    const auto expect = [&](const std::string& text, const char* word) {
        EXPECT_NE(text.find(word), std::string::npos) << word << ": " << text;
    };
    const std::string own = "command = [\"python3\", \"own.py\"]\nmjcf = ";
    expect(error_of("[parameters]\nrate_N_per_mm = {}\n", own + "\"spring.xml\""), "did you mean rate_N_per_m");
    expect(error_of("", own + "\"arm.xml\""), "case.toml:3:1: model.mjcf: arm.xml not found");
    expect(error_of("", own + "3"), "the file of a MuJoCo model");
    expect(error_of("", "command = [\"python3\", \"-c\", \"raise ValueError('too old')\"]\nmjcf = \"spring.xml\""), "too old");
    expect(error_of("", "command = [\"echo\", \"{}\"]\nmjcf = \"spring.xml\""), "model.mjcf");
}

/// The companion itself, where MuJoCo is installed.
class Mujoco : public ::testing::Test {
protected:
    void SetUp() override {
        if (!fs::exists(FUSEE_MUJOCO)) GTEST_SKIP() << "NOT TESTED: fusee-mujoco was not built, libmujoco-dev is missing";
    }
    /// Answers of one process for this body of <mujoco>.
    std::vector<json> ask(const std::string& body, const std::vector<json>& questions) {
        core::write_file(folder_.path() / "m.xml", "<mujoco><compiler angle='radian'/>" + body + "</mujoco>");
        core::Companion process({FUSEE_MUJOCO, "m.xml"}, folder_.path(), {}, "test");
        std::vector<json> answers;
        for (const json& question : questions) {
            std::string line;
            EXPECT_EQ(process.ask(question.dump(), std::chrono::seconds(30), line), core::Companion::End::kAnswered) << process.errors();
            answers.push_back(json::parse(line));
        }
        return answers;
    }
    static json question(const json& parameters, const json& inputs, const json& outputs) {
        return {{"id", 1}, {"parameters", parameters}, {"inputs", inputs}, {"outputs", outputs}};
    }
    core::TemporaryFolder folder_;
    /// A point mass of 2 kg on a rod of 0.5 m below a hinge, and a slide with a motor beside it.
    const std::string plant_ =
        "<option timestep='0.001'/><worldbody><body name='bob'><joint name='swing' axis='0 1 0' damping='0.2'/>"
        "<inertial pos='0 0 -0.5' mass='2' diaginertia='1e-6 1e-6 1e-6'/></body>"
        "<body name='cart'><joint name='rail' type='slide' axis='1 0 0'/><inertial pos='0 0 0' mass='3' diaginertia='1 1 "
        "1'/></body></worldbody>"
        "<actuator><motor name='push' joint='rail'/><position name='hold' joint='swing' kp='40'/></actuator>"
        "<sensor><actuatorfrc name='pushed' actuator='push'/><framepos name='place' objtype='body' objname='cart'/></sensor>";
    const json time_ = {0.0, 0.3, 0.5};
};

TEST_F(Mujoco, NamesWhatTheFileHasAndWhatItLacks) {
    const json found = ask(plant_, {{{"id", 0}, {"describe", true}}}).front();
    EXPECT_EQ(found["parameters"]["bob_mass_kg"], (json{{"nominal", 2.0}, {"tolerance", 0.02}}));
    EXPECT_EQ(found["parameters"]["swing_damping_Nms"]["nominal"], 0.2);
    EXPECT_FALSE(found["effects"].contains("swing_damping_Nms")) << "it has a tolerance";
    EXPECT_EQ(found["effects"]["rail_frictionloss_N"]["frees"], json{"rail_frictionloss_N"});
    EXPECT_EQ(found["effects"]["rail_stiffness_N_per_m"]["frees"], (json{"rail_stiffness_N_per_m", "rail_springref_m"}));
    EXPECT_EQ(found["parameters"]["hold_kp_Nm_per_rad"]["nominal"], 40.0);
    EXPECT_EQ(found["parameters"]["push_gain"]["nominal"], 1.0);
    for (const auto& [name, effect] : found["effects"].items()) EXPECT_GT(effect["usual"][0], 0.0) << name;
}

TEST_F(Mujoco, ActuatorsWithoutAConstantGainHaveTheirBiasAlone) {
    const std::string body =
        "<worldbody><body><joint name='a/b'/><geom size='0.1'/></body></worldbody><actuator><general name='odd' joint='a/b' "
        "gaintype='affine' gainprm='1 0 0' biastype='affine' biasprm='0 -1 0'/><velocity name='v' joint='a/b' kv='3'/></actuator>";
    const json found = ask(body, {{{"id", 0}, {"describe", true}}}).front()["parameters"];
    EXPECT_EQ(found["odd_bias1"]["nominal"], -1.0);
    EXPECT_FALSE(found.contains("odd_kp_Nm_per_rad"));
    EXPECT_EQ(found["v_kv_Nms"]["nominal"], 3.0);
    EXPECT_TRUE(found.contains("a_b_damping_Nms")) << "of a/b";
    EXPECT_TRUE(found.contains("body1_mass_kg"));
}

TEST_F(Mujoco, MovesAsTheLawsSay) {
    // x = F t^2/(2 m) of the cart: 3 N on 3 kg, and with another mass and gain 2 * 3 N on 4 kg.
    const json push = {{"t_s", time_}, {"push_N", {3.0, 3.0, 3.0}}};
    const auto moved = ask(plant_, {question(json::object(), push, {"rail_m", "rail_m_per_s", "pushed_N", "place_0"}),
                                    question({{"cart_mass_kg", 4.0}, {"push_gain", 2.0}}, push, {"rail_m"}),
                                    question({{"rail_frictionloss_N", 4.0}}, push, {"rail_m"})});
    EXPECT_NEAR(moved[0]["outputs"]["rail_m"][2].get<double>(), 0.125, 5e-4);
    EXPECT_NEAR(moved[0]["outputs"]["rail_m_per_s"][2].get<double>(), 0.5, 1e-6);
    EXPECT_EQ(moved[0]["outputs"]["pushed_N"], (json{3.0, 3.0, 3.0}));
    EXPECT_NEAR(moved[0]["outputs"]["place_0"][2].get<double>(), 0.125, 5e-4);
    EXPECT_NEAR(moved[1]["outputs"]["rail_m"][2].get<double>(), 0.1875, 1e-3);
    EXPECT_NEAR(moved[2]["outputs"]["rail_m"][2].get<double>(), 0.0, 2e-3) << "friction above the push; MuJoCo's creeps";
    // The servo holds the bob where k (goal - q) = m g l sin(q); its gain counts on both sides.
    const json hold = {{"t_s", {0.0, 30.0}}, {"hold_goal_rad", {0.5, 0.5}}, {"swing_begin_rad", {0.4, 0.4}}};
    const auto held = ask(plant_, {question({{"swing_damping_Nms", 5.0}}, hold, {"swing_rad"}),
                                   question({{"swing_damping_Nms", 5.0}, {"hold_kp_Nm_per_rad", 80.0}}, hold, {"swing_rad"})});
    for (const auto& [answer, kp] : {std::pair(held[0], 40.0), std::pair(held[1], 80.0)}) {
        const double q = answer["outputs"]["swing_rad"][1];
        EXPECT_NEAR(kp * (0.5 - q), 2.0 * 9.81 * 0.5 * std::sin(q), 1e-6);
        EXPECT_EQ(answer["outputs"]["swing_rad"][0], 0.4) << "it begins where the column says";
    }
}

TEST_F(Mujoco, RefusesWithAReason) {
    const json rest = {{"t_s", time_}};
    const auto answers =
        ask(plant_, {question(json::object(), {{"t_s", time_}, {"pull_N", time_}}, {"rail_m"}),
                     question(json::object(), rest, {"rail_rad"}), question(json::object(), rest, {"place"}),
                     question({{"bob_mass_kg", -1.0}}, rest, {"rail_m"}), question(json::object(), {{"push", time_}}, {"rail_m"}),
                     question({{"push_gain", 1e12}}, {{"t_s", time_}, {"push", time_}}, {"rail_m"})});
    const std::vector<std::string> words{"push, hold", "sensors", "place_0 to _2", "bob_mass_kg", "t_s", "diverged"};
    for (std::size_t i = 0; i < words.size(); ++i) {
        ASSERT_TRUE(answers[i].contains("error")) << answers[i];
        EXPECT_NE(answers[i]["error"].get<std::string>().find(words[i]), std::string::npos) << answers[i];
    }
    EXPECT_NE(ask("<worldbdy/>", {{{"id", 0}, {"describe", true}}}).front()["error"].get<std::string>().find("m.xml"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_.path() / "MUJOCO_LOG.TXT"));
}

}  // namespace
}  // namespace fusee::simulator
