#include "fusee/simulator/model.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <random>
#include <regex>

#include "experiments.h"
#include "fusee/core/error.h"
#include "fusee/diagnosis/diagnose.h"
#include "ports.h"
#include "simulator/fixture.h"

// A simulator as a model of the engine: ports, figures, answers asked for once, verdicts.
namespace fusee::simulator {
namespace {

using inference::Setting;

/// F = k x + f sign(v): parameters in the order friction_N, rate_N_per_m.
Columns pulled(const Request& request) {
    const std::vector<double>& x = request.inputs->at("x_m");
    Columns answer;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double v = i + 1 < x.size() ? x[i + 1] - x[i] : x[i] - x[i - 1];
        answer["force_N"].push_back((*request.parameters)[1] * x[i] + (*request.parameters)[0] * std::copysign(1.0, v));
    }
    return answer;
}

/// The spring's case with runs measured at these figures, pulled `reach` times as far, and noise as stated.
Case measured(double friction, double rate, const std::string& port = "", double size = 0.0, double reach = 1.0) {
    Case own = fixtures::read_case(fixtures::pulled_spring());
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0.0, 0.1);
    Experiment& experiment = own.experiments[0];
    const std::vector<double> figures{friction, rate};
    for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        Columns& columns = experiment.runs[r].columns;
        for (double& x : columns.at("x_m")) x *= reach;
        std::vector<double> force = pulled({&experiment, r, &figures, &columns}).at("force_N");
        if (port == "offset") apply_port(Port::Kind::kOffset, size, nullptr, force);
        if (port == "drift") apply_port(Port::Kind::kDrift, size, &columns.at("t_s"), force);
        for (double& value : force) value += normal(random);
        columns["force_N"] = force;
    }
    return own;
}

diagnosis::Diagnosis diagnosed(const Case& own, unsigned jobs = 1) {
    return diagnosis::diagnose_model(Simulated(own, pulled), {own.name, own.sha256}, {.jobs = jobs, .progress = {}});
}

TEST(Ports, DoWhatTheirNamesSay) {
    const std::vector<double> time{0.0, 1.0, 2.0, 3.0}, first{0.0, 2.0, -4.0, 1.0};
    const auto through = [&](Port::Kind kind, double size) {
        std::vector<double> column = first;
        apply_port(kind, size, &time, column);
        return column;
    };
    EXPECT_EQ(through(Port::Kind::kOffset, 1.0), (std::vector<double>{1.0, 3.0, -3.0, 2.0}));
    EXPECT_EQ(through(Port::Kind::kScale, 0.5), (std::vector<double>{0.0, 3.0, -6.0, 1.5}));
    EXPECT_EQ(through(Port::Kind::kDelay, 0.5), (std::vector<double>{0.0, 1.0, -1.0, -1.5}));
    EXPECT_EQ(through(Port::Kind::kDrift, 3.0), (std::vector<double>{0.0, 3.0, -2.0, 4.0}));
    EXPECT_EQ(through(Port::Kind::kDeadZone, 1.5), (std::vector<double>{0.0, 0.5, -2.5, 0.0}));
}

TEST(Ports, HaveTheUnitOfTheirColumn) {
    gap_case::CaseTexts texts = fixtures::pulled_spring();
    for (auto& [file, text] : texts) {
        text = std::regex_replace(text, std::regex("x_m"), "drive_V");
        text = std::regex_replace(text, std::regex("force_N"), "current_A");
    }
    std::map<std::string, std::string> units;
    for (const Port& port : ports_of(fixtures::read_case(texts))) units[port.effect.id] = port.effect.parameters.front().unit;
    EXPECT_EQ(units.at("port.drive_V.offset"), "V");
    EXPECT_EQ(units.at("port.current_A.drift"), "A");
    EXPECT_EQ(units.at("port.current_A.scale"), "1");
    EXPECT_EQ(units.at("port.current_A.delay"), "s");
    EXPECT_EQ(unit_in("torque_constant_Nm_per_A"), "Nm_per_A");
}

TEST(Ports, WhereARunBeginsIsNoSignal) {
    gap_case::CaseTexts texts = fixtures::pulled_spring();
    std::string& toml = texts["case.toml"];
    toml.replace(toml.find("\"t_s\", "), 7, "\"t_s\", \"cart_begin_m\", ");
    toml += "[columns.pull]\ncart_begin_m = \"x_m\"\n";
    const Case own = fixtures::read_case(texts);
    EXPECT_EQ(own.experiments[0].runs[0].columns.at("cart_begin_m"), own.experiments[0].runs[0].columns.at("x_m"))
        << "one column as two inputs";
    for (const Port& port : ports_of(own)) EXPECT_NE(port.column, "cart_begin_m");
}

TEST(Simulated, HasTheEffectsOfTheCaseTheFiguresAndThePorts) {
    const Case own = fixtures::read_case(fixtures::pulled_spring());
    std::vector<std::string> ids;
    const Simulated model(own, pulled);
    for (const inference::Effect& effect : model.effects()) ids.push_back(effect.id);
    EXPECT_EQ(
        ids, (std::vector<std::string>{"friction", "rate_N_per_m", "port.force_N.offset", "port.force_N.scale", "port.force_N.delay",
                                       "port.force_N.drift", "port.x_m.offset", "port.x_m.scale", "port.x_m.delay", "port.x_m.dead_zone"}));
    ASSERT_EQ(model.build().size(), 1U);
    EXPECT_EQ(model.build()[0].name, "rate_N_per_m");
    ASSERT_EQ(model.experiments()[0].places.size(), 72U);
    EXPECT_EQ(model.experiments()[0].places[24].block, 1);  // a run is held out as a whole
}

TEST(Simulated, OfALongLogEverySoManyRowsAreCompared) {
    Case own = fixtures::read_case(fixtures::pulled_spring());
    Columns& longest = own.experiments[0].runs[0].columns;
    for (auto& [name, values] : longest) values.assign(2 * kMostCompared, 0.0);
    for (std::size_t i = 0; i < longest["x_m"].size(); ++i) longest["x_m"][i] = 1e-6 * static_cast<double>(i);
    std::size_t rows = 0;
    const Simulated model(own, [&rows](const Request& request) {
        rows = std::max(rows, request.inputs->at("x_m").size());
        return pulled(request);
    });
    EXPECT_EQ(rows, 2 * kMostCompared);
    const std::size_t compared = (2 * kMostCompared + 2) / 3 + 8 + 8;  // the two others have 24 rows
    EXPECT_EQ(model.experiments()[0].rows, compared);
    const inference::Outputs outputs = model.predict({{0.0}, {}}, inference::Extent::kAll);
    ASSERT_EQ(outputs[0].size(), compared);
    EXPECT_EQ(model.experiments()[0].places.size(), compared);
    EXPECT_DOUBLE_EQ(outputs[0][5], 1000.0 * 15e-6);
}

TEST(Simulated, AsksEachQuestionOnce) {
    const Case own = fixtures::read_case(fixtures::pulled_spring());
    std::atomic<int> asked = 0;
    const Simulated model(own, [&](const Request& request) {
        ++asked;
        return pulled(request);
    });
    EXPECT_EQ(asked, 4);  // three runs, the first twice
    Setting setting{{0.0}, {}};
    const inference::Outputs nominal = model.predict(setting, inference::Extent::kAll);
    setting.effects = {{{"port.force_N.offset"}, {2.0}}};
    const inference::Outputs shifted = model.predict(setting, inference::Extent::kAll);
    EXPECT_EQ(asked, 4);  // a port of an output needs no simulation
    EXPECT_DOUBLE_EQ(shifted[0][5], nominal[0][5] + 2.0);
    setting.effects = {{{"port.x_m.scale"}, {0.1}}};
    EXPECT_NEAR(model.predict(setting, inference::Extent::kAll)[0][5], 1.1 * nominal[0][5], 1e-12);
    EXPECT_EQ(asked, 7);
    setting = {{10.0}, {{{"rate_N_per_m"}, {90.0}}, {{"friction"}, {0.5}}}};
    (void)model.predict(setting, inference::Extent::kAll);
    (void)model.predict(setting, inference::Extent::kAll);
    EXPECT_EQ(asked, 10);
}

TEST(Simulated, RefusesASimulatorThatIsNoModel) {
    const Case own = fixtures::read_case(fixtures::pulled_spring());
    int asked = 0;
    EXPECT_THROW(Simulated(own,
                           [&](const Request& request) {
                               Columns answer = pulled(request);
                               answer["force_N"][0] += ++asked;
                               return answer;
                           }),
                 core::InvalidInput);
    EXPECT_THROW(Simulated(own, [](const Request&) -> Columns { throw inference::Refusal("too stiff"); }), core::InvalidInput);
}

TEST(Simulated, FaultsOfAnAnswerAreNamed) {
    const Case own = fixtures::read_case(fixtures::pulled_spring());
    const Request request{&own.experiments[0], 0, nullptr, nullptr};
    EXPECT_EQ(fault_of({}, request), "an answer without the output force_N");
    EXPECT_EQ(fault_of({{"force_N", {1.0, 2.0}}}, request), "2 values of force_N for 24 rows");
    Columns bad{{"force_N", std::vector<double>(24, 1.0)}};
    EXPECT_EQ(fault_of(bad, request), "");
    bad["force_N"][7] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(fault_of(bad, request), "inf in row 8 of force_N");
}

TEST(Simulated, AnEffectIsNamedWithTheWordsOfItsCase) {
    const diagnosis::Diagnosis found = diagnosed(measured(0.8, 1010.0));
    ASSERT_EQ(found.verdict, diagnosis::VerdictKind::kIdentified) << diagnosis_json(found);
    EXPECT_EQ(found.effects[0].cause.id, "friction");
    EXPECT_TRUE(found.effects[0].parameter.ci95.holds(0.8));
    ASSERT_FALSE(found.meanings.empty());
    EXPECT_EQ(found.meanings[0].remedy, "Oil it.");
    EXPECT_LT(found.gap.heldout_after, 0.5 * found.gap.heldout_before);
}

/// F = k x up to a limit: parameters in the order limit_N, rate_N_per_m.
Columns limited(const Request& request) {
    Columns answer;
    const double limit = request.parameters->at(0);
    for (const double x : request.inputs->at("x_m")) answer["force_N"].push_back(std::clamp(request.parameters->at(1) * x, -limit, limit));
    return answer;
}

// The runs go to 20 N and the rig ends at 15 N; the limit is stated where they do not reach it, the second one eight usual distances away.
TEST(Simulated, ALimitThatIsStatedBeyondTheRunsIsNamed) {
    for (const std::string nominal : {"30.0", "100.0"}) {
        gap_case::CaseTexts texts = fixtures::pulled_spring();
        const std::size_t effect = texts["case.toml"].find("friction_N = ");
        texts["case.toml"].replace(effect, std::string::npos,
                                   "limit_N = {nominal = " + nominal +
                                       "}\n\n[effects.limit]\nfrees = [\"limit_N\"]\nusual = 10.0\nrange = [0.1, " + nominal + "]\n");
        Case own = fixtures::read_case(texts);
        std::mt19937_64 random(7);
        std::normal_distribution<double> normal(0.0, 0.1);
        const std::vector<double> rig{15.0, 1005.0};
        for (std::size_t r = 0; r < own.experiments[0].runs.size(); ++r) {
            Columns& columns = own.experiments[0].runs[r].columns;
            columns["force_N"] = limited({&own.experiments[0], r, &rig, &columns}).at("force_N");
            for (double& value : columns["force_N"]) value += normal(random);
        }
        const diagnosis::Diagnosis found =
            diagnosis::diagnose_model(Simulated(own, limited), {own.name, own.sha256}, {.jobs = 1, .progress = {}});
        ASSERT_EQ(found.verdict, diagnosis::VerdictKind::kIdentified) << nominal << diagnosis_json(found);
        EXPECT_EQ(found.effects.at(0).cause.id, "limit");
        EXPECT_NEAR(std::stod(nominal) + found.effects[0].parameter.value, 15.0, 0.2);
    }
}

TEST(Simulated, ASensorThatIsShiftedIsNamed) {
    const diagnosis::Diagnosis found = diagnosed(measured(0.0, 990.0, "offset", 1.5));
    ASSERT_FALSE(found.effects.empty()) << diagnosis_json(found);  // the zero of the way is the same cause: x_0 = F_0/k
    EXPECT_TRUE(found.effects[0].cause.id == "port.force_N.offset" || found.effects[0].cause.id == "port.x_m.offset");
}

// 5 % of the span of a column is no experience: what the rows show is a cause, however small beside it.
TEST(Simulated, ADriftThatIsSmallBesideItsColumnIsNamed) {
    const diagnosis::Diagnosis found = diagnosed(measured(0.0, 1000.0, "drift", 1.0, 10.0));
    ASSERT_EQ(found.verdict, diagnosis::VerdictKind::kIdentified) << diagnosis_json(found);
    EXPECT_EQ(found.effects.at(0).cause.id, "port.force_N.drift");
    EXPECT_TRUE(found.effects[0].parameter.ci95.holds(1.0)) << found.effects[0].parameter.value;
}

// Then the model without a cause has nothing to fit.
TEST(Simulated, EveryFigureMayBeExact) {
    Case own = measured(0.8, 1000.0);
    for (Parameter& parameter : own.parameters) parameter.sigma = 0.0;
    const diagnosis::Diagnosis found = diagnosed(own);
    ASSERT_EQ(found.verdict, diagnosis::VerdictKind::kIdentified) << diagnosis_json(found);
    EXPECT_EQ(found.effects.at(0).cause.id, "friction");
}

TEST(Simulated, NothingIsNamedWhereNothingIsWrong) {
    const diagnosis::Diagnosis found = diagnosed(measured(0.0, 1025.0));
    EXPECT_TRUE(found.effects.empty()) << diagnosis_json(found);
    EXPECT_LT(found.gap.after, 1.2);
}

TEST(Simulated, CausesAreCarriedOnlyToTheSameModel) {
    const Case own = measured(0.8, 1010.0), other = measured(0.8, 985.0);
    EXPECT_NO_THROW(require_same_model(own, other));
    const diagnosis::Against on =
        diagnosis::against(Simulated(other, pulled), {"tuesday", ""}, diagnosed(own), {.jobs = 1, .progress = {}});
    ASSERT_EQ(on.causes.size(), 1U);
    EXPECT_EQ(on.causes[0].survival, diagnosis::Survival::kAgrees);
    gap_case::CaseTexts texts = fixtures::pulled_spring();
    texts["case.toml"] = std::regex_replace(texts["case.toml"], std::regex("friction_N"), "drag_N");
    try {
        require_same_model(own, fixtures::read_case(texts));
        FAIL();
    } catch (const core::InvalidInput& refusal) {
        EXPECT_NE(std::string(refusal.what()).find("without effect friction (frees friction_N)"), std::string::npos) << refusal.what();
    }
}

TEST(Simulated, TheAnswerDoesNotDependOnTheNumberOfThreads) {
    const Case own = measured(0.8, 1010.0);
    EXPECT_EQ(diagnosis_json(diagnosed(own, 1)), diagnosis_json(diagnosed(own, 4)));
}

}  // namespace
}  // namespace fusee::simulator
