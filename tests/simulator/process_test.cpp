#include "fusee/simulator/process.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "simulator/fixture.h"

// The process of a simulator: what it is asked, and what it may not do.
namespace fusee::simulator {
namespace {

namespace fs = std::filesystem;

class Process : public ::testing::Test {
protected:
    /// A case whose process runs this body for each `request`.
    Case written(const std::string& body, const std::string& more = "") {
        gap_case::CaseTexts texts = fixtures::pulled_spring();
        std::string& toml = texts["case.toml"];
        toml.insert(toml.find("\n\n"), more);
        for (const auto& [name, text] : texts) core::write_file(folder_.path() / name, text);
        core::write_file(folder_.path() / "spring.py",
                         "import json, os, sys, time\nfor line in sys.stdin:\n    r = json.loads(line)\n" + body);
        return read_case(folder_.path());
    }
    /// The error of the first question.
    std::string error_of(const std::string& body, const std::string& more = "") {
        const Case own = written(body, more);
        try {
            const Simulated model(own, start_processes(own, 1));
        } catch (const core::InputError& e) {
            return e.what();
        }
        return "";
    }
    static void expect_words(const std::string& text, const std::vector<std::string>& words) {
        for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
    }

    core::TemporaryFolder folder_;
    const std::string answer_ =
        "    x = r['inputs']['x_m']\n"
        "    print(json.dumps({'id': r['id'], 'outputs': {'force_N': [r['parameters']['rate_N_per_m'] * v for v in x]}}))\n";
};

TEST_F(Process, AnswersInTheCasesFolder) {
    const Case own =
        written("    assert os.path.exists('case.toml') and r['experiment'] == 'pull' and len(r['inputs']['t_s']) == 24\n" + answer_);
    const Simulated model(own, start_processes(own, 2));
    const inference::Outputs outputs = model.predict({{20.0}, {}}, inference::Extent::kAll);
    EXPECT_NEAR(outputs[0][30], 1020.0 * own.experiments[0].runs[1].columns.at("x_m")[6], 1e-9);
}

TEST_F(Process, ARefusalIsNoError) {
    const Case own =
        written("    if r['parameters']['friction_N'] > 1: print(json.dumps({'id': r['id'], 'error': 'it sticks'})); continue\n" + answer_);
    const Simulated model(own, start_processes(own, 1));
    EXPECT_THROW((void)model.predict({{0.0}, {{{"friction"}, {2.0}}}}, inference::Extent::kAll), inference::Refusal);
    EXPECT_NO_THROW((void)model.predict({{0.0}, {}}, inference::Extent::kAll));
}

TEST_F(Process, WhatItDoesWrongIsToldWithTheQuestion) {
    const std::string dead = error_of("    raise ValueError('no such spring')\n");
    expect_words(dead, {"case.toml: model.command", "exit code 1", "a.csv of pull", "no such spring)", "cd " + folder_.path().string()});
    const std::size_t at = dead.find(" < ") + 3;
    const fs::path question = dead.substr(at, dead.find_first_of(";)", at) - at);
    expect_words(core::read_file(question), {"\"experiment\": \"pull\"", "\"rate_N_per_m\": 1000"});
    fs::remove(question);
    expect_words(error_of("    time.sleep(100)\n", "\ntimeout_s = 0.2"), {"no answer within 0.2 s"});
    expect_words(error_of("    print(json.dumps({'id': r['id'], 'outputs': {'force_N': [1.0]}}))\n"), {"1 values of force_N for 24 rows"});
    expect_words(error_of("    print(json.dumps({'id': r['id'], 'outputs': {'force_N': [float('nan')] * 24}}))\n"),
                 {"no such answer", "NaN"});
    expect_words(error_of("    print(json.dumps({'id': 77, 'outputs': {}}))\n"), {"no such answer", "77", "the id of the question"});
    expect_words(error_of("    print(json.dumps({'id': r['id'], 'outputs': {'force_N': [1.0, None]}}))\n"),
                 {"no such answer", "outputs.force_N[1]: null", "a number"});
    expect_words(error_of("    print('starting')\n" + answer_), {"no such answer: starting"});
    fs::remove(question);
}

TEST_F(Process, AnErrorOfNullIsNone) {
    const Case own = written(
        "    x = r['inputs']['x_m']\n    print(json.dumps({'id': r['id'], 'error': None, 'outputs': {'force_N': [2.0 * v for v in "
        "x]}}))\n");
    const Simulated model(own, start_processes(own, 1));
    EXPECT_NEAR(model.predict({{0.0}, {}}, inference::Extent::kAll)[0][6], 2.0 * own.experiments[0].runs[0].columns.at("x_m")[6], 1e-12);
}

TEST_F(Process, AProgramThatIsMissingIsNamed) {
    const auto error_with = [&](const std::string& command) -> std::string {
        gap_case::CaseTexts texts = fixtures::pulled_spring();
        std::string& toml = texts["case.toml"];
        toml.replace(toml.find("[\"python3\", \"spring.py\"]"), 24, command);
        for (const auto& [name, text] : texts) core::write_file(folder_.path() / name, text);
        const Case own = read_case(folder_.path());
        try {
            (void)start_processes(own, 1);
        } catch (const core::InvalidInput& e) {
            return e.what();
        }
        return "";
    };
    expect_words(error_with("[\"./no-such-model\", \"spring.py\"]"), {"./no-such-model", "an executable file"});
    expect_words(error_with("\"python3 spring.py\""), {"python3 spring.py", "an array of words"});
}

}  // namespace
}  // namespace fusee::simulator
