#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

#include "fusee/diagnosis/diagnose.h"
#include "fusee/inference/problem.h"
#include "fusee/inference/search.h"
#include "fusee/simulator/model.h"

// What a diagnosis costs: questions to a simulator of some milliseconds each.
namespace fusee::simulator {
namespace {

constexpr std::size_t kRows = 80;
constexpr double kStep_s = 0.03;
constexpr int kPieces = 15;  // steps of a row

/// Places of the parameters of `arm`.
enum Figure : std::size_t { kMotor, kLink, kRate, kGravity, kDrag, kDamping, kLoss, kFriction, kGap, kFigures };

/// A motor that turns a pendulum through a spring, by a torque or to a goal.
Columns turned(const Request& request) {
    const std::vector<double>& p = *request.parameters;
    const bool goal = request.experiment->name == "track";
    const std::vector<double>& u = request.inputs->at(goal ? "goal_rad" : "torque_Nm");
    double x = 0.0, q = 0.0, v = 0.0, w = 0.0;
    Columns answer;
    const double h = kStep_s / kPieces;
    const auto braked = [h](double speed, double friction, double inertia) {
        return std::copysign(std::max(0.0, std::abs(speed) - h * friction / inertia), speed);
    };
    for (const double command : u) {
        answer["motor_rad"].push_back(x);
        answer["link_rad"].push_back(q);
        for (int i = 0; i < kPieces; ++i) {
            const double apart = x - q, slack = 0.5 * p[kGap];
            const double spring = p[kRate] * std::copysign(std::max(0.0, std::abs(apart) - slack), apart) + p[kLoss] * (v - w);
            const double torque = goal ? 20.0 * (command - x) - v : command;
            v = braked(v + h * (torque - spring - p[kDamping] * v) / p[kMotor], p[kDrag], p[kMotor]);
            w = braked(w + h * (spring - p[kGravity] * std::sin(q)) / p[kLink], p[kFriction], p[kLink]);
            x += h * v;
            q += h * w;
        }
    }
    return answer;
}

/// Two experiments of three runs, seven figures with tolerances, measured at these figures with noise.
Case arm(const std::vector<double>& truth, std::uint64_t seed) {
    Case own;
    own.name = "arm";
    own.parameters = {{"motor_kgm2", "kgm2", 0.05, 0.0015, true},
                      {"link_kgm2", "kgm2", 0.03, 0.0009, true},
                      {"rate_Nm_per_rad", "Nm_per_rad", 20, 0.4, true},
                      {"gravity_Nm", "Nm", 0.9, 0.018, true},
                      {"drag_Nm", "Nm", 0.1, 0.01, true},
                      {"damping_Nms", "Nms", 0.15, 0.015, true},
                      {"loss_Nms", "Nms", 0.05, 0.01, true},
                      {"friction_Nm", "Nm", 0.0},
                      {"gap_rad", "rad", 0.0}};
    own.effects = {{"friction", {kFriction}, {0.05}, {{0.0, 1.0}}, "", ""}, {"backlash", {kGap}, {0.02}, {{0.0, 0.4}}, "", ""}};
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 0.002);
    for (const bool goal : {false, true}) {
        const std::string command = goal ? "goal_rad" : "torque_Nm";
        Experiment& experiment = own.experiments.emplace_back(
            Experiment{goal ? "track" : "torque", {"t_s", command}, {{"motor_rad", "rad", 0.002}, {"link_rad", "rad", 0.002}}, {}});
        for (int r = 0; r < 3; ++r) {
            Run& run = experiment.runs.emplace_back();
            run.file = experiment.name + std::to_string(r) + ".csv";
            for (std::size_t i = 0; i < kRows; ++i) {
                const double t = kStep_s * static_cast<double>(i);
                run.columns["t_s"].push_back(t);
                run.columns[command].push_back((goal ? 0.7 : 1.0) * std::sin((2.0 + 1.7 * r) * t) + 0.2 * std::sin(8.0 * t));
            }
            Columns measured = turned({&experiment, static_cast<std::size_t>(r), &truth, &run.columns});
            for (auto& [name, values] : measured) {
                for (double& value : values) value += normal(random);
                run.columns[name] = values;
            }
        }
    }
    return own;
}

/// Questions of the diagnosis of a rig with these figures. A simulator of 10 ms answers 12 000 in a minute on two cores.
int asked_for(const std::vector<double>& truth, std::uint64_t seed, const std::string& named) {
    const Case own = arm(truth, seed);
    std::atomic<int> asked = 0;
    const Simulated model(own, [&](const Request& request) {
        ++asked;
        return turned(request);
    });
    const diagnosis::Diagnosis found = diagnosis::diagnose_model(model, {own.name, own.sha256}, {.jobs = 2, .progress = {}});
    EXPECT_EQ(found.effects.size(), named.empty() ? 0U : 1U);
    EXPECT_EQ(found.effects.empty() ? "" : found.effects.front().cause.id, named);
    return asked;
}

const std::vector<double> kBuilt{0.0512, 0.0293, 20.3, 0.91, 0.108, 0.139, 0.052, 0.0, 0.0};

TEST(Cost, AFaultlessRigTakesLessThanAMinuteOnTwoCores) { EXPECT_LT(asked_for(kBuilt, 41, ""), 4000); }

TEST(Cost, AFaultTakesLessThanAMinuteOnTwoCores) {
    std::vector<double> rubs = kBuilt;
    rubs[kFriction] = 0.06;
    EXPECT_LT(asked_for(rubs, 42, "friction"), 7000);
}

TEST(Cost, WhatIsKnownIsNotAskedAgain) {
    const Case own = arm(kBuilt, 44);
    std::atomic<int> asked = 0;
    const Simulated model(own, [&](const Request& request) {
        ++asked;
        return turned(request);
    });
    const std::unique_ptr<inference::Menu> menu = model.menu();
    inference::Setting setting{std::vector<double>(7, 0.0), {}};
    const std::vector<double> first = menu->predict(setting);
    const int once = asked;
    EXPECT_EQ(model.menu()->predict(setting), first);
    setting.effects = {{{"port.link_rad.offset"}, {0.1}}};  // of an output: no matter of the simulator
    EXPECT_NE(menu->predict(setting), first);
    EXPECT_EQ(asked, once);
}

TEST(Cost, AStepThatIsRefusedIsTakenToTheOtherSide) {
    const Case own = arm(kBuilt, 46);
    const Simulated model(own, [&](const Request& request) {
        if ((*request.parameters)[kDamping] < 0.15) throw inference::Refusal("too little damping");
        return turned(request);
    });
    const inference::Problem problem(model);
    EXPECT_TRUE(problem.slopes({}, problem.start({}), 0, 7).allFinite());
}

TEST(Cost, WhatIsWithinToleranceOrATraceIsNoCause) {
    const Case own = arm(kBuilt, 45);
    const Simulated model(own, turned);
    const inference::Problem problem(model);
    const auto stands = [&](const char* id, double size) {
        inference::Fit fit;
        fit.causes = {{id}};
        fit.x = problem.start(fit.causes);
        fit.covariance = 1e-12 * Eigen::MatrixXd::Identity(fit.x.size(), fit.x.size());
        fit.x[fit.x.size() - 1] = size / problem.effect(id).parameters.front().scale;
        return inference::sizes_stand(problem, fit);
    };
    EXPECT_FALSE(stands("link_kgm2", 3.9 * 0.0009));
    EXPECT_TRUE(stands("link_kgm2", -4.1 * 0.0009));
    EXPECT_FALSE(stands("port.link_rad.scale", 0.0009));
    EXPECT_TRUE(stands("port.link_rad.scale", 0.0011));
    EXPECT_TRUE(stands("friction", 1e-5)) << "the usual size is the user's guess";
}

TEST(Cost, SlopesOfFiguresHoldNearWhereTheyWereTaken) {
    const Case own = arm(kBuilt, 43);
    const Simulated model(own, turned);
    const inference::Problem problem(model);
    Eigen::VectorXd x = problem.start({});
    const Eigen::VectorXd nominal = x;
    inference::HeldSlopes held{problem.slopes({}, x, 0, x.size()), x};
    const Eigen::MatrixXd before = held.slopes;
    x[kRate] = 0.9;
    problem.renew(held, {}, x);
    EXPECT_EQ(held.at, nominal);
    EXPECT_EQ(held.slopes, before);
    x[kRate] = 1.1;
    problem.renew(held, {}, x);
    EXPECT_EQ(held.at, x);
    const Eigen::MatrixXd there = problem.slopes({}, x, 0, x.size());  // to both sides
    EXPECT_LT((held.slopes - there).norm(), 0.05 * there.norm());
    EXPECT_LT((held.slopes - there).col(kRate).norm(), 0.3 * (before - there).col(kRate).norm());
}

}  // namespace
}  // namespace fusee::simulator
