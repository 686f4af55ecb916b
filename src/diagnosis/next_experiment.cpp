#include "next_experiment.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fusee/core/parallel.h"
#include "fusee/inference/constants.h"
#include "next_experiment_information.h"

namespace fusee::diagnosis {

namespace {

/// The outcomes of a hypothesis in all measurements of a menu.
Eigen::VectorXd predict_menu(const inference::Problem& problem, const inference::Menu& menu, const inference::Causes& causes,
                             const Eigen::VectorXd& x) {
    const std::vector<double> all = menu.predict(problem.setting(causes, x));
    return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// Prediction of a rival for every value: at its fit, and its change by one sigma along each column of the root of its covariance.
struct PredictedOutcome {
    Eigen::VectorXd mean;
    Eigen::MatrixXd spread;
};

PredictedOutcome predicted_outcome(const inference::Problem& problem, const inference::Menu& menu, const inference::Fit& rival,
                                   unsigned jobs) {
    const Eigen::MatrixXd root = rival.covariance.llt().matrixL();
    PredictedOutcome seen;
    seen.mean = predict_menu(problem, menu, rival.causes, rival.x);
    seen.spread.resize(seen.mean.size(), root.cols());
    core::parallel_for(static_cast<std::size_t>(root.cols()), jobs, [&](std::size_t k) {
        const auto column = static_cast<int>(k);
        seen.spread.col(column) = predict_menu(problem, menu, rival.causes, rival.x + root.col(column)) - seen.mean;
    });
    return seen;
}

/// sqrt(weight)/sigma of every value, as a fit of such rows weights it; `predicted` gives the magnitudes.
Eigen::VectorXd precisions(const inference::Menu& menu, const Eigen::VectorXd& predicted) {
    const std::vector<double> all = menu.precisions({predicted.begin(), predicted.end()});
    return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// (a - b)^T (I + S)^-1 (a - b) with the mean covariance S of both, by the Woodbury identity. 0 where one of them cannot be simulated.
double squared_distance(const Eigen::VectorXd& difference, const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    Eigen::MatrixXd open(difference.size(), a.cols() + b.cols());
    open << a, b;
    if (!difference.allFinite() || !open.allFinite()) return 0.0;
    open *= std::sqrt(0.5);
    const Eigen::VectorXd along = open.transpose() * difference;
    Eigen::MatrixXd normal = open.transpose() * open;
    normal.diagonal().array() += 1.0;
    return std::max(0.0, difference.squaredNorm() - along.dot(normal.llt().solve(along)));
}

/// Squared distances of the rivals in each measurement.
std::vector<Eigen::MatrixXd> distances(const inference::Problem& problem, const inference::Menu& menu,
                                       const std::vector<const inference::Fit*>& rivals, unsigned jobs) {
    const Eigen::VectorXd precision = precisions(menu, predict_menu(problem, menu, rivals[0]->causes, rivals[0]->x));
    std::vector<PredictedOutcome> predicted;
    for (const inference::Fit* rival : rivals) predicted.push_back(predicted_outcome(problem, menu, *rival, jobs));
    const auto n = static_cast<int>(rivals.size());
    std::vector<Eigen::MatrixXd> all(menu.measurements().size());
    core::parallel_for(all.size(), jobs, [&](std::size_t m) {
        const std::vector<int>& places = menu.measurements()[m].values;
        const Eigen::VectorXd weight = precision(places) * std::sqrt(menu.measurements()[m].repeats);
        std::vector<Eigen::VectorXd> means;
        std::vector<Eigen::MatrixXd> spreads;
        for (const PredictedOutcome& seen : predicted) {
            means.emplace_back(weight.cwiseProduct(seen.mean(places)));
            spreads.emplace_back(weight.asDiagonal() * seen.spread(places, Eigen::all));
        }
        all[m] = Eigen::MatrixXd::Zero(n, n);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < i; ++j) all[m](i, j) = all[m](j, i) = squared_distance(means[i] - means[j], spreads[i], spreads[j]);
    });
    return all;
}

/// Squared distances of two.
Eigen::MatrixXd between_two(double square) { return square * (Eigen::MatrixXd::Ones(2, 2) - Eigen::MatrixXd::Identity(2, 2)); }

/// True if `a` is the better proposal.
bool serves_better(const NextExperiment& a, const NextExperiment& b, double enough) {
    const bool a_decides = a.information >= enough, b_decides = b.information >= enough;
    if (a_decides != b_decides) return a_decides;
    if (a_decides) return a.cost < b.cost;
    return a.information * b.cost > b.information * a.cost;
}

/// The best of each experiment that gives some of the `most` bits: first the cheapest that is expected to decide, then by bits per minute.
std::vector<NextExperiment> best_of_each(const std::vector<NextExperiment>& all, double most) {
    std::vector<NextExperiment> best;
    for (const NextExperiment& next : all) {
        if (next.information < inference::kWorthwhile * most) continue;
        const auto same = std::find_if(best.begin(), best.end(), [&](const NextExperiment& b) { return b.experiment == next.experiment; });
        if (same == best.end())
            best.push_back(next);
        else if (serves_better(next, *same, inference::kDecides * most))
            *same = next;
    }
    if (best.empty()) return best;
    std::stable_sort(best.begin(), best.end(),
                     [&](const auto& a, const auto& b) { return serves_better(a, b, inference::kDecides * most); });
    std::stable_sort(best.begin() + 1, best.end(),
                     [](const auto& a, const auto& b) { return a.information * b.cost > b.information * a.cost; });
    return best;
}

/// What a usual size of each cause changes in every value of the menu, all else as in the `null` fit.
std::vector<Eigen::VectorXd> changes_by(const inference::Problem& problem, const inference::Menu& menu, const inference::Fit& null,
                                        const std::vector<inference::Cause>& causes, unsigned jobs) {
    const Eigen::VectorXd without = predict_menu(problem, menu, null.causes, null.x);
    std::vector<Eigen::VectorXd> changes(causes.size());
    core::parallel_for(causes.size(), jobs, [&](std::size_t i) {
        Eigen::VectorXd x = problem.start({causes[i]});
        x.head(null.x.size()) = null.x;
        x[null.x.size()] = 1.0;
        changes[i] = predict_menu(problem, menu, {causes[i]}, x) - without;
    });
    return changes;
}

NextExperiment offered(const inference::Measurement& m, double bits) {
    return {sentence_of(m, bits), m.experiment, m.set_points, m.variable, bits, m.cost};
}

/// Factor by which the rivals would have to differ more to be decided; above inference::kLargestFactor: never.
double factor_to_decide(std::span<const double> probabilities, const Eigen::MatrixXd& distances, double enough) {
    double low = 1.0, high = 2.0;
    while (high < inference::kLargestFactor && expected_information(probabilities, high * high * distances) < enough) high *= 2.0;
    for (int i = 0; i < 20; ++i) {
        const double middle = std::sqrt(low * high);
        (expected_information(probabilities, middle * middle * distances) < enough ? low : high) = middle;
    }
    return high;
}

/// The effect size of the most probable rival times `factor`; "" without effect or beyond its range.
std::string enlarged(const inference::Problem& problem, const std::vector<const inference::Fit*>& rivals,
                     std::span<const double> probabilities, double factor) {
    const inference::Fit& rival =
        *rivals[static_cast<std::size_t>(std::max_element(probabilities.begin(), probabilities.end()) - probabilities.begin())];
    if (rival.causes.empty()) return "";
    const inference::Cause& cause = rival.causes.front();
    const inference::EffectParameter& size = problem.effect(cause.id).parameters.front();
    const double value = factor * size.scale * rival.x[static_cast<int>(problem.build().size())];
    if (size.allowed.low > 0.0 || !size.allowed.holds(value)) return "";
    const std::string side = cause.side == "none" ? "" : fmt::format(" ({})", cause.side);
    return fmt::format(": {}{} of {:.2g}{}", cause.id, side, value, size.unit == "1" ? "" : " " + size.unit);
}

NextExperiment none_tells(const inference::Problem& problem, const std::vector<const inference::Fit*>& rivals,
                          std::span<const double> probabilities, NextExperiment best, const Eigen::MatrixXd& distances) {
    const double factor = factor_to_decide(probabilities, distances, inference::kDecides * entropy(probabilities));
    const std::string size = factor < inference::kLargestFactor
                                 ? fmt::format("Effects {:.2g} times as large as found could be distinguished{}.", factor,
                                               enlarged(problem, rivals, probabilities, factor))
                                 : std::string("Larger effects would not change that.");
    best.text = fmt::format("No usual measurement distinguishes these causes. {} The best one is: {}", size, best.text);
    return best;
}

}  // namespace

std::string sentence_of(const inference::Measurement& measurement, double bits) {
    return fmt::format("{}: {:.2f} bit, {:.0f} min.", measurement.what, bits, measurement.cost);
}

std::vector<double> expected_bits(const inference::Problem& problem, const inference::Menu& menu,
                                  const std::vector<const inference::Fit*>& rivals, std::span<const double> probabilities, unsigned jobs) {
    std::vector<double> bits;
    for (const Eigen::MatrixXd& d : distances(problem, menu, rivals, jobs)) bits.push_back(expected_information(probabilities, d));
    return bits;
}

std::vector<double> most_bits_against_first(const inference::Problem& problem, const std::vector<const inference::Fit*>& fits,
                                            unsigned jobs) {
    const std::unique_ptr<inference::Menu> menu = problem.model().menu();
    if (menu == nullptr) return {};
    const std::vector<double> even{0.5, 0.5};
    std::vector<double> most(fits.size() - 1, 0.0);
    for (const Eigen::MatrixXd& d : distances(problem, *menu, fits, jobs))
        for (std::size_t i = 0; i < most.size(); ++i)
            most[i] = std::max(most[i], expected_information(even, between_two(d(0, static_cast<int>(i) + 1))));
    return most;
}

std::vector<NextExperiment> showing_experiments(const inference::Problem& problem, const inference::Fit& null,
                                                const std::vector<inference::Cause>& unseen, unsigned jobs) {
    const std::unique_ptr<inference::Menu> offers = problem.model().menu();
    if (offers == nullptr) return {};
    const inference::Menu& menu = *offers;
    const std::vector<Eigen::VectorXd> changes = changes_by(problem, menu, null, unseen, jobs);
    const Eigen::VectorXd precision = precisions(menu, predict_menu(problem, menu, null.causes, null.x));
    const Eigen::MatrixXd spread = predicted_outcome(problem, menu, null, jobs).spread;
    const std::vector<double> even{0.5, 0.5};
    std::vector<NextExperiment> all;
    for (const inference::Measurement& m : menu.measurements()) {
        const std::vector<int>& places = m.values;
        const Eigen::VectorXd weight = precision(places) * std::sqrt(m.repeats);
        const Eigen::MatrixXd open = weight.asDiagonal() * spread(places, Eigen::all);
        double bits = 0.0;
        for (const Eigen::VectorXd& change : changes) {
            const double square = squared_distance(weight.cwiseProduct(change(places)), open, open);
            bits += expected_information(even, between_two(square));
        }
        all.push_back(offered(m, bits / static_cast<double>(changes.size())));
    }
    std::vector<NextExperiment> best = best_of_each(all, 1.0);
    if (best.empty())
        best.push_back(
            *std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.information < b.information; }));
    return best;
}

std::vector<NextExperiment> next_experiments(const inference::Problem& problem, const std::vector<const inference::Fit*>& rivals,
                                             std::span<const double> probabilities, unsigned jobs) {
    std::vector<double> p(probabilities.begin(), probabilities.end());
    const double sum = std::accumulate(p.begin(), p.end(), 0.0);
    for (double& value : p) value /= sum;
    const double most = entropy(p);
    if (rivals.size() < 2 || !(most > 0.0)) return {};
    const std::unique_ptr<inference::Menu> offers = problem.model().menu();
    if (offers == nullptr) return {};
    const inference::Menu& menu = *offers;
    const std::vector<Eigen::MatrixXd> squared = distances(problem, menu, rivals, jobs);
    std::size_t tells_most = 0;
    std::vector<NextExperiment> all;
    for (std::size_t m = 0; m < squared.size(); ++m) {
        all.push_back(offered(menu.measurements()[m], expected_information(p, squared[m])));
        if (all[m].information > all[tells_most].information) tells_most = m;
    }
    std::vector<NextExperiment> best = best_of_each(all, most);
    if (best.empty()) best.push_back(none_tells(problem, rivals, p, all[tells_most], squared[tells_most]));
    return best;
}

}  // namespace fusee::diagnosis
