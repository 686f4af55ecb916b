#include <gtest/gtest.h>

#include <cmath>

#include "fusee/inference/pursue.h"
#include "refine.h"

// Fits in a local minimum: a smaller hypothesis must not lose because of one.
namespace fusee::inference {
namespace {

/// A tone, a sin((w + d) t) with d the deviation of its rate: a fit from a wrong rate ends in another minimum. Effects: `known`, whose
/// rate is that of the model (2 rad/s), and `free`, which has a rate of its own.
class Tone final : public Model {
public:
    static constexpr double kRate = 2.0, kNoise = 0.05;

    Tone(double amplitude, double rate) {
        Experiment& own = experiments_.emplace_back();
        own.name = "record";
        own.variable = "t_s";
        own.outputs = {"y"};
        own.measured = tone(amplitude, rate);
        own.rows = own.measured.size();
        for (std::size_t i = 0; i < own.rows; ++i) {
            own.sigma.push_back(kNoise);
            own.places.push_back({0.1 * static_cast<double>(i), "y", "y", static_cast<int>(i / 20)});
        }
        const EffectParameter size{"a", "1", 1.0, {-4.0, 4.0}, 0.0};
        effects_.push_back({"known", "a sin(2 t)", {"none"}, {size}, {1.0}, {0}, {}});
        effects_.push_back({"free", "a sin(w t)", {"none"}, {size, {"w", "rad/s", 1.0, {0.5, 9.0}, kRate}}, {1.0}, {0}, {}});
    }
    [[nodiscard]] const std::vector<Experiment>& experiments() const override { return experiments_; }
    [[nodiscard]] const std::vector<BuildParameter>& build() const override { return build_; }
    [[nodiscard]] const std::vector<Effect>& effects() const override { return effects_; }
    [[nodiscard]] Outputs predict(const Setting& setting, Extent) const override {
        std::vector<double> y(kRows, 0.0);
        for (const Setting::Applied& own : setting.effects) {
            const double rate = (own.cause.id == "known" ? kRate : own.values[1]) + setting.build.front();
            const std::vector<double> more = tone(own.values.front(), rate);
            for (std::size_t i = 0; i < kRows; ++i) y[i] += more[i];
        }
        return {y};
    }

private:
    static constexpr std::size_t kRows = 80;
    [[nodiscard]] static std::vector<double> tone(double amplitude, double rate) {
        std::vector<double> y;
        for (std::size_t i = 0; i < kRows; ++i) y.push_back(amplitude * std::sin(rate * 0.1 * static_cast<double>(i)));
        return y;
    }
    std::vector<Experiment> experiments_;
    std::vector<BuildParameter> build_{{"rate", "rad/s", 0.5, kRate}};
    std::vector<Effect> effects_;
};

const Cause kKnown{"known"}, kFree{"free"};

TEST(Restarted, AFitIsStartedAgainWhereAFurtherParameterIsHalfAsLargeAgain) {
    const Tone model(1.0, 3.0);  // 1.5 times the rate of the start
    const Problem problem(model);
    const Fit stuck = fit(problem, {kFree}, problem.start({kFree}));
    const Fit again = restarted(problem, stuck, 2);
    EXPECT_NEAR(again.x[2] + 0.5 * again.x[0], 3.0, 0.01);  // the model's own rate takes its share
    EXPECT_NEAR(again.x[1], 1.0, 0.01);
    EXPECT_LT(misfits(problem, again.seen())[0], 0.1);
    EXPECT_GT(misfits(problem, stuck.seen())[0], 1.5);
    EXPECT_GE(restarted(problem, again, 1).log_evidence, again.log_evidence);
}

TEST(Reconsidered, TermsThatBeatAFitInALocalMinimumAreDropped) {
    const Tone model(1.0, 3.0);
    const Problem problem(model);
    Search found;
    found.fits = {fit(problem, {kKnown}, problem.start({kKnown})), fit(problem, {}, problem.start({}))};
    found.left_out.resize(2);
    found.null = 1;
    found.log_posterior = {0.0, found.fits[1].log_evidence - found.fits[0].log_evidence + kEffectOdds};
    found.probability = probabilities(found.log_posterior);
    Eigen::VectorXd start = problem.start({kKnown});
    start[0] = 2.0;  // sigmas: the rate of the record
    start[1] = 1.0;
    const Fit right = fit(problem, {kKnown}, start);
    const double gain = right.log_evidence - found.best().log_evidence;
    ASSERT_GT(gain, 100.0);

    const auto with_odds = [&](double odds) { return reconsidered(problem, found, {right, {odds}, {1.0}, {}}, 2); };
    const Reconsidered dropped = with_odds(gain - 1.0), kept = with_odds(gain + 1.0);
    EXPECT_FALSE(dropped.terms);
    EXPECT_TRUE(kept.terms);
    for (const Reconsidered& own : {dropped, kept}) {
        EXPECT_NEAR(own.found.best().cost, right.cost, 1e-3 * right.cost);
        EXPECT_NEAR(own.found.log_posterior[1], found.log_posterior[1] - gain, 0.1);
        EXPECT_FALSE(own.found.left_out.front().x.empty());
    }
}

}  // namespace
}  // namespace fusee::inference
