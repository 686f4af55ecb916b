#include "next_experiment.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "inference/fixture.h"
#include "next_experiment_information.h"

namespace fusee::diagnosis {
namespace {

using namespace fixtures;

const std::vector<double> kEven{0.5, 0.5};

Eigen::MatrixXd equal_distances(int n, double distance) {
    return distance * distance * (Eigen::MatrixXd::Ones(n, n) - Eigen::MatrixXd::Identity(n, n));
}

TEST(Information, OfTwoIsTheCapacityOfABinaryChannel) {
    EXPECT_EQ(expected_information(kEven, equal_distances(2, 0.0)), 0.0);
    // Antipodal signals of 1 in noise of 1 (0 dB): 0.4859 bit, the four digits of the tables
    EXPECT_NEAR(expected_information(kEven, equal_distances(2, 2.0)), 0.4859, 5e-5);
    // Little signal: p (1 - p) d^2/2 nats; the next term is of the order of d^4
    EXPECT_NEAR(expected_information(std::vector{0.3, 0.7}, equal_distances(2, 0.05)) / (0.21 * 0.0025 / 2.0 / std::log(2.0)), 1.0, 2e-3);
    EXPECT_NEAR(expected_information(std::vector{0.3, 0.7}, equal_distances(2, 20.0)), entropy(std::vector{0.3, 0.7}), 1e-6);
}

TEST(Information, GrowsWithTheDistanceUpToTheEntropyAndTheBoundStaysBelow) {
    const std::vector<double> three{0.6, 0.3, 0.1}, third_out{0.5, 0.5, 0.0};
    double last_two = 0.0, last_three = 0.0;
    for (double d = 0.25; d < 30.0; d *= 1.5) {
        const double two = expected_information(kEven, equal_distances(2, d)), more = expected_information(three, equal_distances(3, d));
        EXPECT_TRUE(two >= last_two && two <= 1.0);
        EXPECT_TRUE(more >= last_three && more <= entropy(three));
        EXPECT_LE(expected_information(third_out, equal_distances(3, d)), two + 1e-12);
        last_two = two;
        last_three = more;
    }
    EXPECT_NEAR(last_three, entropy(three), 1e-6);
}

/// Rivals fitted to one case.
struct Rivals {
    Rivals(gap_case::Case of, const std::vector<inference::Causes>& causes) : gap_case(std::move(of)), problem(gap_case) {
        for (const inference::Causes& c : causes) fits.push_back(best_fit(problem, c));
        for (const inference::Fit& fit : fits) all.push_back(&fit);
    }
    gap_case::Case gap_case;
    JointProblem problem;
    std::vector<inference::Fit> fits;
    std::vector<const inference::Fit*> all;
};

/// Friction at one load: constant or in proportion to the load?
const Rivals& friction() {
    static const Rivals rivals(measured_case(break_aways({0.8}, 4, false), {kCoulomb}, {0.06}, 1.0, 3), {{kCoulomb}, {kLoad}});
    return rivals;
}
/// A menu of break-aways and pulls alone, which cost no motion.
effects::MeasurementMenu usual_sheets(const gap_case::Case& gap_case) {
    effects::MeasurementMenu menu = effects::measurement_menu(gap_case);
    for (gap_case::Rows& rows : menu.sheets) {
        gap_case::Rows kept;
        kept.breakaway = rows.breakaway;
        kept.spring_pull = rows.spring_pull;
        rows = kept;
    }
    std::erase_if(menu.measurements, [](const effects::SheetMeasurement& m) { return m.experiment > gap_case::Experiment::kSpringPull; });
    return menu;
}
effects::JointMenu usual_menu(const JointProblem& problem) { return {problem.joint, usual_sheets(problem.gap_case())}; }
/// The most that a measurement told of which `words` stand in its text.
double most_of(const inference::Menu& menu, const std::vector<double>& bits, const std::string& words) {
    double most = -1.0;
    for (std::size_t m = 0; m < bits.size(); ++m)
        if (menu.measurements()[m].what.find(words) != std::string::npos) most = std::max(most, bits[m]);
    return most;
}

TEST(NextExperiment, FrictionLawsAreSplitByAnotherLoadOnTheirOwnSide) {
    const effects::JointMenu menu = usual_menu(friction().problem);
    const std::vector<double> bits = expected_bits(friction().problem, menu, friction().all, kEven, 1);
    EXPECT_GT(most_of(menu, bits, "Break the agonist away"), 0.9);
    EXPECT_LT(most_of(menu, bits, "Break the antagonist away"), 0.05);
    EXPECT_LT(most_of(menu, bits, "Pull"), 0.05);
}

TEST(NextExperiment, TheFirstIsTheCheapestThatDecides) {
    const auto next = next_experiments(friction().problem, friction().all, std::vector{3.0, 3.0}, 1);  // any sum
    ASSERT_GE(next.size(), 3U);
    const std::unique_ptr<inference::Menu> offers = friction().problem.joint.menu();
    const inference::Menu& menu = *offers;
    const std::vector<double> bits = expected_bits(friction().problem, menu, friction().all, kEven, 1);
    EXPECT_GE(next[0].information, 0.9);
    for (std::size_t m = 0; m < bits.size(); ++m) {
        EXPECT_TRUE(bits[m] >= 0.0 && bits[m] <= 1.0) << menu.measurements()[m].what;
        EXPECT_TRUE(bits[m] < 0.9 || menu.measurements()[m].cost >= next[0].cost) << menu.measurements()[m].what;
    }
    for (std::size_t i = 2; i < next.size(); ++i) EXPECT_GE(next[i - 1].information / next[i - 1].cost, next[i].information / next[i].cost);
    for (const NextExperiment& n : next) {
        EXPECT_FALSE(n.set_points.empty() || n.variable.empty() || n.experiment.empty());
        EXPECT_NE(n.text.find(" bit, "), std::string::npos) << n.text;
        EXPECT_NE(n.experiment, "spring_pull") << n.text;
    }
}

TEST(NextExperiment, MoreNoiseTellsLess) {
    const effects::JointMenu menu = usual_menu(friction().problem);
    gap_case::Case noisy = friction().gap_case;
    noisy.sensors.torque_noise *= 30.0;
    noisy.sensors.breakaway_scatter *= 30.0;
    noisy.sensors.torque_noise_relative *= 30.0;
    const JointProblem louder(noisy);
    const std::vector<double> bits = expected_bits(friction().problem, menu, friction().all, kEven, 1);
    const std::vector<double> fewer = expected_bits(louder, usual_menu(louder), friction().all, kEven, 1);
    for (std::size_t m = 0; m < bits.size(); ++m) EXPECT_LE(fewer[m], bits[m] + 1e-12) << menu.measurements()[m].what;
    EXPECT_LT(most_of(menu, fewer, "Break"), most_of(menu, bits, "Break") - 0.01);
}

/// What a rival may show of a break-away measurement: mean, and root of the covariance.
struct Outcome {
    Outcome(const JointProblem& problem, const inference::Fit& rival, const gap_case::Rows& rows, const Eigen::VectorXd& variance) {
        const auto progress = [&](const Eigen::VectorXd& x) {
            const joint_model::BuiltRig rig = problem.joint.rig(problem.setting(rival.causes, x));
            const std::vector<double> loads =
                joint_model::predict_experiment(rig, rows, problem.gap_case().protocol, gap_case::Experiment::kBreakAway);
            return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(loads.data(), static_cast<int>(loads.size())));
        };
        mean = progress(rival.x);
        Eigen::MatrixXd covariance = variance.asDiagonal();
        const Eigen::MatrixXd by_sigma = rival.covariance.llt().matrixL();
        for (int k = 0; k < by_sigma.cols(); ++k) {
            const Eigen::VectorXd moved = progress(rival.x + by_sigma.col(k)) - mean;
            covariance += moved * moved.transpose();
        }
        root = covariance.llt().matrixL();
    }
    [[nodiscard]] double log_likelihood(const Eigen::VectorXd& y) const {
        return -0.5 * root.triangularView<Eigen::Lower>().solve(y - mean).squaredNorm() - root.diagonal().array().log().sum();
    }
    Eigen::VectorXd mean;
    Eigen::MatrixXd root;
};

/// Bits that random outcomes tell on average of two even rivals.
double drawn_bits(const std::array<Outcome, 2>& rivals) {
    constexpr int kDraws = 20000;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    double left = 0.0;
    for (int n = 0; n < kDraws; ++n) {
        const Outcome &truth = rivals[static_cast<std::size_t>(n % 2)], &other = rivals[static_cast<std::size_t>(1 - n % 2)];
        const Eigen::VectorXd z = Eigen::VectorXd::NullaryExpr(truth.mean.size(), [&] { return normal(random); });
        const Eigen::VectorXd y = truth.mean + truth.root * z;
        left += std::log2(1.0 + std::exp(other.log_likelihood(y) - truth.log_likelihood(y))) / kDraws;
    }
    return 1.0 - left;
}

TEST(NextExperiment, OutcomesDrawnAtRandomTellAsMuchAsExpected) {
    gap_case::Case noisy = friction().gap_case;
    noisy.sensors.torque_noise = 0.08;  // so that about half a bit can be told
    const JointProblem problem(noisy);
    effects::MeasurementMenu sheets = usual_sheets(noisy);
    std::erase_if(sheets.measurements,
                  [](const effects::SheetMeasurement& m) { return m.what.find("the agonist away at 0.16, 0.8 Nm") == std::string::npos; });
    ASSERT_EQ(sheets.measurements.size(), 1U);
    const effects::SheetMeasurement asked = sheets.measurements[0];
    gap_case::Case again = noisy;
    again.rows = gap_case::Rows{};
    for (const std::size_t i : asked.rows) again.rows.breakaway.push_back(sheets.sheets[0].breakaway[i]);
    const joint_model::Uncertainty known = joint_model::uncertainty(again);
    const std::vector<double>& sigma = known.sigma[gap_case::Experiment::kBreakAway];
    const Eigen::VectorXd variance = Eigen::Map<const Eigen::ArrayXd>(sigma.data(), static_cast<int>(sigma.size())).square() /
                                     (known.weight[static_cast<int>(gap_case::Experiment::kBreakAway)] * asked.repeats);
    const double drawn = drawn_bits(
        {Outcome(problem, friction().fits[0], again.rows, variance), Outcome(problem, friction().fits[1], again.rows, variance)});
    const double expected = expected_bits(problem, effects::JointMenu(problem.joint, sheets), friction().all, kEven, 1)[0];
    EXPECT_TRUE(expected > 0.2 && expected < 0.9) << expected;
    EXPECT_NEAR(expected, drawn, 0.03);  // drawing leaves 0.005; the rest is what differs between the two scatters
}

TEST(NextExperiment, TheSameForAnyThreads) {
    const effects::JointMenu menu = usual_menu(friction().problem);
    EXPECT_EQ(expected_bits(friction().problem, menu, friction().all, kEven, 1),
              expected_bits(friction().problem, menu, friction().all, kEven, 4));
}

TEST(NextExperiment, APullOfItsSeriesSpringSplitsTheSides) {
    // As if the joint were known to be softer, by a fifth of that, and neither which spring nor what the tolerances left.
    const Rivals rivals(measured_case(break_aways({0.8}, 1, false), {}, {}, 1.0, 5), {{kRate}, {kOtherRate}});
    std::vector<inference::Fit> fits = rivals.fits;
    const auto size = static_cast<int>(rivals.problem.build().size());
    for (inference::Fit& fit : fits) {
        fit.x.setZero();
        fit.x[size] = -2.0;
        fit.covariance = Eigen::MatrixXd::Identity(size + 1, size + 1);
        fit.covariance(size, size) = 0.16;
    }
    const effects::JointMenu menu = usual_menu(rivals.problem);
    const std::vector<double> bits = expected_bits(rivals.problem, menu, {&fits[0], &fits[1]}, kEven, 1);
    EXPECT_GT(most_of(menu, bits, "Pull K_SE of the agonist alone"), 0.9);
    EXPECT_LT(most_of(menu, bits, "Pull K_PE"), 0.01);
    EXPECT_LT(most_of(menu, bits, "Break"), 0.01);
}

TEST(NextExperiment, ALogSplitsDragAtTheGearsFromDragAtTheJoint) {
    gap_case::Rows rows;
    for (const gap_case::DeadBandRow& row : set_points(small_template()).dead_band)
        if (row.repeat == 1 && row.cocontraction > 0.7 && row.cocontraction < 0.9) rows.dead_band.push_back(row);
    const Rivals rivals(measured_case(rows, {kDrag}, {0.05}, 1.0, 3), {{kDrag}, {kJointDrag}});
    const auto next = next_experiments(rivals.problem, rivals.all, kEven, 1);
    const auto log = std::find_if(next.begin(), next.end(), [](const NextExperiment& n) { return n.experiment == "log"; });
    ASSERT_NE(log, next.end());
    EXPECT_GT(log->information, 0.9);
    for (const NextExperiment& n : next) EXPECT_FALSE(n.experiment == "spring_pull" || n.experiment == "breakaway") << n.text;
}

TEST(NextExperiment, NothingToDecideAndNothingThatDecides) {
    const inference::Problem& problem = friction().problem;
    const inference::Fit* one = friction().all[0];
    EXPECT_TRUE(next_experiments(problem, {}, {}, 1).empty());
    EXPECT_TRUE(next_experiments(problem, {one}, std::vector{1.0}, 1).empty());
    EXPECT_TRUE(next_experiments(problem, friction().all, std::vector{1.0, 0.0}, 1).empty());
    const auto same = next_experiments(problem, {one, one}, kEven, 1);
    ASSERT_EQ(same.size(), 1U);
    EXPECT_EQ(same[0].information, 0.0);
    EXPECT_NE(same[0].text.find("No usual measurement distinguishes these causes. Larger effects would not"), std::string::npos)
        << same[0].text;
}

TEST(NextExperiment, WhatIsTooSmallIsToldWithTheSizeThatWouldDo) {
    std::vector<inference::Fit> fits = friction().fits;
    for (inference::Fit& fit : fits) {  // both too small to see
        const auto last = fit.x.size() - 1;
        fit.x.setZero();
        fit.x[last] = 0.005;
        fit.covariance = Eigen::MatrixXd::Identity(last + 1, last + 1);
        fit.covariance(last, last) = 1e-4;
    }
    const auto next = next_experiments(friction().problem, {&fits[0], &fits[1]}, std::vector{0.7, 0.3}, 1);
    ASSERT_EQ(next.size(), 1U);
    EXPECT_LT(next[0].information, 0.1);
    EXPECT_NE(next[0].text.find("times as large as found could be distinguished: gear.coulomb (agonist) of"), std::string::npos)
        << next[0].text;
}

TEST(NextExperiment, AMenuAsksForTorquesThatTheMotorsReached) {
    const effects::MeasurementMenu menu = effects::measurement_menu(small_case(break_aways({0.8}, 1, false)));
    for (const gap_case::Rows& rows : menu.sheets) {
        for (const gap_case::BreakAway& row : rows.breakaway) EXPECT_TRUE(row.motor_torque > 0.0 && row.motor_torque <= 0.8);
        for (const gap_case::DeadBandRow& row : rows.dead_band) EXPECT_LE(row.cocontraction, 0.8);
        for (const gap_case::LogRow& row : rows.log) EXPECT_LE(std::max(row.torque_agonist, row.torque_antagonist), 0.8);
    }
    for (const gap_case::Experiment e : gap_case::kAllExperiments)
        EXPECT_TRUE(std::any_of(menu.measurements.begin(), menu.measurements.end(),
                                [&](const effects::SheetMeasurement& m) { return m.experiment == e; }));
    EXPECT_FALSE(effects::measurement_menu(small_case(pulls(5))).measurements.empty());  // no torque shown: what the springs carry
    for (const effects::SheetMeasurement& m : menu.measurements) EXPECT_GT(m.cost, 0.0);
}

}  // namespace
}  // namespace fusee::diagnosis
