#include "fusee/inference/search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fusee/inference/screen.h"
#include "inference/fixture.h"

// Sets of three effects and more.
namespace fusee::inference {
namespace {

using Shares = std::vector<double>;  ///< of the tones sin(t), sin(2 t), ...

/// A sum of tones. Each effect adds its shares of them, and so does the figure of the only build parameter, which "figure" changes, too.
class Sum final : public Model {
public:
    Sum(const Shares& rig, const std::vector<Shares>& effects, Shares figure) : shares_(effects), figure_(std::move(figure)) {
        Experiment& own = experiments_.emplace_back();
        own.name = "record";
        own.variable = "t_s";
        own.outputs = {"y"};
        own.measured = tones(rig, 1.0);
        own.rows = own.measured.size();
        for (std::size_t i = 0; i < own.rows; ++i) {
            own.sigma.push_back(0.3);
            own.places.push_back({static_cast<double>(i), "y", "y", static_cast<int>(i / 50)});
        }
        for (std::size_t e = 0; e < effects.size(); ++e) add_effect("effect" + std::to_string(e));
        add_effect("figure");
        shares_.push_back(figure_);
        build_.push_back({"figure", "1", 0.05, 0.0, true, true, {"figure"}, 1.0});
    }
    [[nodiscard]] const std::vector<Experiment>& experiments() const override { return experiments_; }
    [[nodiscard]] const std::vector<BuildParameter>& build() const override { return build_; }
    [[nodiscard]] const std::vector<Effect>& effects() const override { return effects_; }
    [[nodiscard]] Outputs predict(const Setting& setting, Extent) const override {
        std::vector<double> y = tones(figure_, setting.build.front());
        for (const Setting::Applied& own : setting.effects)
            for (std::size_t e = 0; e < effects_.size(); ++e) {
                if (effects_[e].id != own.cause.id) continue;
                const std::vector<double> more = tones(shares_[e], own.values.front());
                for (std::size_t i = 0; i < kRows; ++i) y[i] += more[i];
            }
        return {y};
    }

private:
    static constexpr std::size_t kRows = 400;
    [[nodiscard]] static std::vector<double> tones(const Shares& shares, double size) {
        std::vector<double> y(kRows, 0.0);
        for (std::size_t i = 0; i < kRows; ++i)
            for (std::size_t k = 0; k < shares.size(); ++k) y[i] += size * shares[k] * std::sin(0.015 * static_cast<double>((k + 1) * i));
        return y;
    }
    void add_effect(const std::string& id) { effects_.push_back({id, id, {"none"}, {{"a", "1", 1.0, {-9.0, 9.0}}}, {1.0}, {0}, {}}); }

    std::vector<Experiment> experiments_;
    std::vector<BuildParameter> build_;
    std::vector<Effect> effects_;
    std::vector<Shares> shares_;
    Shares figure_;
};

TEST(Search, AnEffectIsAddedToASetThatAFigureMadeLarger) {
    const Sum model({1.0, 0.9, 1.1, 0.0, 0.0, 0.7}, {{1.0}, {0.0, 1.0}, {0.0, 0.0, 1.0}}, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0});
    const Problem problem(model);
    EXPECT_TRUE(same_causes(search(problem, {}).best().causes, {{"effect0"}, {"effect1"}, {"effect2"}, {"figure"}}));
}

// One size for both is likelier as long as tolerances pay for the rest; the verdict weighs the sizes of the sides (rivals.h).
TEST(Search, ASizeForEachSideIsTriedBesideOneForBoth) {
    const auto gap_case = fixtures::measured_case(fixtures::pulls(2), {fixtures::kRate, fixtures::kOtherRate}, {0.105, 0.049}, 1.0, 5);
    const fixtures::JointProblem problem(gap_case);
    const Search found = search(problem, {});
    ASSERT_EQ(found.best().causes.front().side, "both");
    EXPECT_TRUE(std::any_of(found.fits.begin(), found.fits.end(), [&](const Fit& own) {
        return own.causes.size() == 2 && own.causes.front().id == found.best().causes.front().id &&
               own.causes.front().id == own.causes.back().id;
    }));
}

// In a simulation a friction may look worse than none until all follows it: the break-aways alone tell it.
TEST(Search, AThirdEffectIsFoundByItsDirectRows) {
    gap_case::Rows rows = fixtures::pulls(5);
    rows.breakaway = fixtures::break_aways({0.1, 0.4, 0.7, 1.0}, 3, true).breakaway;
    rows.log = fixtures::short_log(1.5).log;
    const Causes built{{"pe.rate", "agonist"}, {"joint.coulomb", "none"}, fixtures::kCoulomb};
    const gap_case::Case gap_case = fixtures::measured_case(rows, built, {0.15, 0.09, 0.03}, 1.0, 7);
    const fixtures::JointProblem problem(gap_case);
    EXPECT_TRUE(same_causes(search(problem, {}).best().causes, built));

    const std::vector<Guess> guesses =
        screen(problem, fixtures::best_fit(problem, {built[0], built[1]}), {fixtures::kLoad, fixtures::kCoulomb}, 1);
    ASSERT_EQ(guesses.size(), 2U);
    const std::vector<double> costs = direct_costs(problem, guesses, 1);
    const bool first = guesses[0].causes.back() == fixtures::kCoulomb;
    EXPECT_LT(costs[first ? 0 : 1] + kSecondOdds, costs[first ? 1 : 0]);
}

TEST(EvidenceLeft, IsWhatAMisfitOfOneWouldAdd) {
    const Sum model({1.0}, {}, {1.0});
    const Problem problem(model);
    const auto left = [&](double residual) {
        return evidence_left(problem, Eigen::VectorXd::Constant(problem.residual_count(), residual));
    };
    EXPECT_EQ(left(1.0), 0.0);
    const double square = 9.0 * std::log(13.0 / 9.0);  // of 2 sigma; beyond 1.5^2 its logarithm counts
    EXPECT_NEAR(left(2.0), 0.5 * 400.0 * (2.25 * (1.0 + std::log(square / 2.25)) - 1.0), 1e-9);
}

}  // namespace
}  // namespace fusee::inference
