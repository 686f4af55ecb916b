#include "answer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"
#include "gap_map.h"
#include "isolability.h"
#include "next_experiment.h"
#include "power.h"
#include "unknown_terms.h"

namespace fusee::diagnosis {

namespace {

constexpr double kNormal95 = 1.959964;
constexpr double kLeastAlternative = 1e-3;  ///< probability below which an alternative is not listed
constexpr std::size_t kMostRivals = 4;      ///< rivals of the next experiment: each costs as much as a fit
constexpr double kSmallLeak = 0.05;         ///< probability below which a hypothesis gets no further experiment

/// 95 % interval over the folds of the gap on held-out rows.
core::Range interval_over_folds(const inference::Problem& problem, const Eigen::VectorXd& held) {
    const std::vector<int> fold = folds(problem);
    double mean = 0.0, square = 0.0;
    for (int f = 0; f < inference::kFolds; ++f) {
        Eigen::VectorXd own = held;
        for (int i = 0; i < own.size(); ++i)
            if (fold[static_cast<std::size_t>(i)] != f) own[i] = 0.0;
        const double gap = root_mean_square(problem, own) * std::sqrt(static_cast<double>(inference::kFolds));
        mean += gap / inference::kFolds;
        square += gap * gap / inference::kFolds;
    }
    const double half = inference::student95(inference::kFolds) * std::sqrt(std::max(0.0, square - mean * mean) / (inference::kFolds - 1));
    return {std::max(0.0, mean - half), mean + half};
}

std::string names_of(const inference::Causes& causes) {
    std::string names;
    for (const inference::Cause& cause : causes) names += (names.empty() ? "" : " with ") + cause.id;
    return names;
}

}  // namespace

Answer::Answer(const Subject& subject, const inference::Problem& problem, const inference::Search& found, const Verdict& verdict)
    : problem_(problem), found_(found), verdict_(verdict), shown_(&found.best()) {
    sigma_ = tolerance_sigma(problem, found.fits[found.null].jacobian);
    nominal_ = problem.predict({}, problem.start({}));
    before_ = problem.residual(nominal_).cwiseQuotient(sigma_);
    diagnosis_.case_name = subject.name;
    diagnosis_.case_sha256 = subject.sha256;
    diagnosis_.verdict = verdict.verdict;
    diagnosis_.remarks = problem.model().remarks();
    diagnosis_.remarks.insert(diagnosis_.remarks.end(), verdict.remarks.begin(), verdict.remarks.end());
}

void Answer::name(const inference::FoundTerms& terms) {
    if (verdict_.verdict == VerdictKind::kIdentified || verdict_.verdict == VerdictKind::kAmbiguous)
        diagnosis_.remarks.push_back(fmt::format("an unknown effect explains the gap better than {}", names_of(found_.best().causes)));
    diagnosis_.verdict = VerdictKind::kUnknown;
    diagnosis_.unknown_terms = unknown_terms(problem_, terms);
    shown_ = &terms.fit;
}

void Answer::compare(const inference::Split& kept) {
    const Eigen::VectorXd after = shown_->residual.cwiseQuotient(sigma_), held = kept.residual.cwiseQuotient(sigma_);
    const Eigen::VectorXd floor = sigma_.cwiseInverse(), expected = kept.expected.cwiseQuotient(sigma_);
    const auto gap = [&](const std::size_t* only) {
        Gap g;
        g.before = g.heldout_before = root_mean_square(problem_, before_, only);
        g.after = root_mean_square(problem_, after, only);
        g.noise_floor = root_mean_square(problem_, floor, only);
        g.heldout_after = root_mean_square(problem_, held, only);
        return g;
    };
    diagnosis_.gap = gap(nullptr);
    diagnosis_.gap.heldout_after_95 = interval_over_folds(problem_, held);
    for (std::size_t e = 0; e < problem_.experiments().size(); ++e) {
        const inference::Experiment& experiment = problem_.experiments()[e];
        if (experiment.rows == 0) continue;
        const Gap own = gap(&e);
        diagnosis_.experiments.push_back({experiment.name, experiment.rows, own, root_mean_square(problem_, expected, &e)});
    }
    diagnosis_.map = gap_map(problem_, before_, after);
    diagnosis_.where =
        gap_contributions(problem_, diagnosis_.verdict == VerdictKind::kUnknown && diagnosis_.unknown_terms.empty() ? after : before_);
    build();
    traces();
}

void Answer::build() {
    const inference::Fit& best = *shown_;
    for (std::size_t k = 0; k < problem_.build().size(); ++k) {
        const inference::BuildParameter& build = problem_.build()[k];
        const auto i = static_cast<Eigen::Index>(k);
        const double value = best.x[i] * build.sigma, half = kNormal95 * std::sqrt(best.covariance(i, i)) * build.sigma;
        diagnosis_.build.push_back({build.name, {value, {value - half, value + half}, build.unit}});
    }
}

void Answer::rank() {
    for (std::size_t h = 0; h < found_.fits.size(); ++h) {
        const inference::Fit& fit = found_.fits[h];
        const inference::Split& left_out = found_.left_out[h];
        Hypothesis row{fit.causes, found_.log_posterior[h], found_.probability[h], fit.cost, kNoFigure, {}};
        if (!left_out.x.empty()) row.left_out = root_mean_square(problem_, left_out.residual.cwiseQuotient(sigma_));
        for (std::size_t c = 0; c < fit.causes.size(); ++c) {
            const int k = problem_.size_at(fit.causes, c);
            const inference::EffectParameter& size = problem_.effect(fit.causes[c].id).parameters.front();
            row.parameters.push_back(parameter_of(fit.x[k], inference::half_interval(fit, left_out, k), size));
        }
        diagnosis_.ranking.push_back(std::move(row));
    }
    found_effects();
}

void Answer::found_effects() {
    const inference::Fit& best = found_.best();
    const bool named = diagnosis_.verdict == VerdictKind::kIdentified || diagnosis_.verdict == VerdictKind::kAmbiguous;
    for (std::size_t c = 0; named && c < best.causes.size(); ++c) {
        const inference::Effect& effect = problem_.effect(best.causes[c].id);
        const auto k = static_cast<std::size_t>(problem_.size_at(best.causes, c));
        FoundEffect found{best.causes[c], 0.0, diagnosis_.ranking.front().parameters[c], {}};
        for (std::size_t h = 0; h < found_.fits.size(); ++h) {
            const inference::Causes& others = found_.fits[h].causes;
            if (std::find(others.begin(), others.end(), found.cause) != others.end()) found.probability += found_.probability[h];
        }
        for (std::size_t p = 1; p < effect.parameters.size(); ++p)
            found.extra.emplace_back(effect.parameters[p].name, best.x[static_cast<Eigen::Index>(k + p)] * effect.parameters[p].scale);
        diagnosis_.effects.push_back(std::move(found));
    }
    for (std::size_t h = named || diagnosis_.verdict == VerdictKind::kNone ? 1 : 0; h < found_.fits.size(); ++h)
        if (found_.probability[h] >= kLeastAlternative || (h == 0 && diagnosis_.verdict == VerdictKind::kUnknown))
            diagnosis_.alternatives.push_back({found_.fits[h].causes, found_.probability[h]});
}

std::vector<inference::Cause> Answer::weigh_power() {
    if (diagnosis_.verdict != VerdictKind::kNone) return {};
    diagnosis_.power = powers_of(problem_, diagnosis_.isolability);
    const std::vector<inference::Cause> unseen = not_shown(diagnosis_.power);
    if (unseen.empty()) return unseen;
    diagnosis_.verdict = VerdictKind::kInconclusive;
    std::vector<std::string> ids;
    for (const inference::Cause& cause : unseen)
        if (ids.empty() || ids.back() != cause.id) ids.push_back(cause.id);
    diagnosis_.remarks.push_back(fmt::format("these rows would not show a usual size of: {}", fmt::join(ids, ", ")));
    return unseen;
}

void Answer::plan_next_experiment(unsigned jobs) {
    const std::vector<inference::Cause> causes = inference::possible_causes(problem_);
    diagnosis_.isolability = isolability(problem_, found_.fits[found_.null], causes, jobs);
    // A refuted nominal rig is not a rival: the question is then which effect comes nearest.
    const bool refuted = verdict_.verdict == VerdictKind::kUnknown && found_.best().causes.empty();
    const double of_all = refuted ? 1.0 - found_.probability[found_.null] : 1.0;
    std::vector<const inference::Fit*> rivals;
    std::vector<double> probabilities;
    for (std::size_t h = 0; h < found_.fits.size() && rivals.size() < kMostRivals; ++h) {
        const double probability = found_.probability[h] / of_all;
        if ((refuted && h == found_.null) || probability < kSmallLeak) continue;
        rivals.push_back(&found_.fits[h]);
        probabilities.push_back(probability);
    }
    if (!diagnosis_.unknown_terms.empty()) {  // what would confirm the form
        const std::vector<double> even{0.5, 0.5};
        diagnosis_.next = next_experiments(problem_, {shown_, &found_.fits[found_.null]}, even, jobs);
    } else if (const std::vector<inference::Cause> unseen = weigh_power(); !unseen.empty())
        diagnosis_.next = showing_experiments(problem_, found_.fits[found_.null], unseen, jobs);
    else if (rivals.size() > 1)
        diagnosis_.next = next_experiments(problem_, rivals, probabilities, jobs);
    if (!diagnosis_.next.empty()) diagnosis_.next_experiment = diagnosis_.next.front().text;
}

}  // namespace fusee::diagnosis
