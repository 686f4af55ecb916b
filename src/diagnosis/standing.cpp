#include "standing.h"

#include <algorithm>
#include <vector>

#include "fusee/inference/constants.h"
#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"

namespace fusee::diagnosis {

namespace {

bool holds_cause(const inference::Causes& causes, const inference::Cause& cause) {
    return std::find(causes.begin(), causes.end(), cause) != causes.end();
}

/// Of all hypotheses with this cause.
double probability_of(const inference::Search& search, const inference::Cause& cause) {
    double sum = 0.0;
    for (std::size_t h = 0; h < search.fits.size(); ++h)
        if (holds_cause(search.fits[h].causes, cause)) sum += search.probability[h];
    return sum;
}

/// The rows of experiments that the fit explains. Rows that stick and slip count as little as their spread says.
std::vector<bool> explained_rows(const inference::Problem& problem, const inference::Fit& fit) {
    const std::vector<double> misfit = misfits(problem, fit.seen());
    std::vector<bool> rows;
    for (int i = 0; i < problem.residual_count(); ++i) {
        const std::size_t e = problem.experiment_of(i);
        rows.push_back(misfit[e] <= problem.experiments()[e].unexplained);
    }
    return rows;
}

/// Do the experiments that the fit explains pay for causes[c]? Without it the rest is fitted again.
bool is_paid_for(const inference::Problem& problem, const inference::Fit& with, std::size_t c, unsigned jobs) {
    const std::vector<bool> rows = explained_rows(problem, with);
    if (std::find(rows.begin(), rows.end(), true) == rows.end()) return false;
    const inference::Fit without = inference::refit_without(problem, with, c, jobs);
    const auto cost = [&](const inference::Fit& of) {  // strained build parameters count: a wrong answer could bend the rig to these rows
        return cost_of(problem, of.causes, of.residual.cwiseQuotient(with.spread), of.x, &rows);
    };
    const double odds = inference::odds_against(problem, with) - inference::odds_against(problem, without);
    return 0.5 * (cost(without) - cost(with)) >= odds;
}

}  // namespace

std::optional<Standing> standing_part(const inference::Problem& problem, const inference::Search& search, unsigned jobs) {
    Standing now{search.best(), search.left_out.front()};
    while (!now.fit.causes.empty()) {
        inference::Causes out = at_bounds(problem, now.fit);
        for (const inference::Cause& cause : contradicted(problem, now.fit, now.left_out)) out.push_back(cause);
        for (std::size_t c = 0; c < now.fit.causes.size(); ++c)
            if (const inference::Cause& cause = now.fit.causes[c];
                !holds_cause(out, cause) && (probability_of(search, cause) < inference::kSure || !is_paid_for(problem, now.fit, c, jobs)))
                out.push_back(cause);
        if (out.empty()) return now;
        inference::Causes left = now.fit.causes;
        Eigen::VectorXd x = now.fit.x;
        for (std::size_t c = left.size(); c-- > 0;) {
            if (!holds_cause(out, left[c])) continue;
            x = problem.without(left, x, c);
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(c));
        }
        if (left.empty()) break;
        now.fit = fit(problem, left, x, {.jobs = jobs});
        if (!std::isfinite(now.fit.log_evidence) || !sizes_stand(problem, now.fit)) break;
        now.left_out = experiments_left_out(problem, search.fits[search.null], now.fit, jobs);
    }
    return std::nullopt;
}

}  // namespace fusee::diagnosis
