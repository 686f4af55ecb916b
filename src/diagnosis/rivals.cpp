#include "rivals.h"

#include <algorithm>
#include <cmath>

#include "fusee/inference/constants.h"
#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"
#include "next_experiment.h"

namespace fusee::diagnosis {

namespace {

/// The other causes of the class of `cause`.
std::vector<inference::Cause> class_of(const Isolability& isolability, const inference::Cause& cause) {
    std::vector<inference::Cause> others;
    for (const std::vector<std::size_t>& members : isolability.classes) {
        std::vector<inference::Cause> all;
        for (const std::size_t m : members) all.push_back(isolability.causes[m]);
        if (std::find(all.begin(), all.end(), cause) == all.end()) continue;
        std::copy_if(all.begin(), all.end(), std::back_inserter(others), [&](const auto& other) { return !(other == cause); });
    }
    return others;
}

/// As many causes, and the rows see less than 3 sigma of difference.
bool is_seen_alike(const inference::Fit& best, const inference::Fit& rival) {
    return rival.causes.size() == best.causes.size() && std::abs(rival.cost - best.cost) < inference::kSeen * inference::kSeen;
}

/// The rows see that, or the ranking leaves it a chance that is worth an experiment.
bool is_open(const inference::Search& search, std::size_t h) {
    if (search.fits[h].causes.empty()) return false;
    return is_seen_alike(search.best(), search.fits[h]) || search.probability[h] >= inference::kSmallLeak;
}

/// Is the hypothesis as the best one, with a size on each side in the place of one for both, and do the two sizes differ beyond their
/// intervals? Refits without one experiment that disagree about a size widen its interval.
bool differs_by_side(const inference::Problem& problem, const inference::Search& search, std::size_t h) {
    const inference::Fit& fit = search.fits[h];
    for (std::size_t b = 0; b < fit.causes.size(); ++b) {
        const std::optional<std::size_t> a = inference::other_side(problem, fit, b);
        if (!a) continue;
        inference::Causes joined = fit.causes;
        joined[*a].side = "both";
        joined.erase(joined.begin() + static_cast<std::ptrdiff_t>(b));
        if (!inference::same_causes(joined, search.best().causes)) continue;
        const int i = problem.effect_size_index(fit.causes, *a), k = problem.effect_size_index(fit.causes, b);
        const double half = std::hypot(half_interval(fit, search.left_out[h], i), half_interval(fit, search.left_out[h], k));
        return std::abs(fit.x[i] - fit.x[k]) > inference::kSidesDiffer * half / inference::kNormal95;
    }
    return false;
}

/// Places of the hypotheses that predict every row as the best one does, to less than 3 sigma of all rows together.
std::vector<std::size_t> coinciding(const inference::Problem& problem, const inference::Search& search) {
    const inference::Fit& best = search.best();
    std::vector<std::size_t> places;
    for (std::size_t h = 1; h < search.fits.size() && places.size() + 1 < inference::kMostRivals; ++h) {
        const inference::Fit& rival = search.fits[h];
        if (best.causes.empty() || !is_seen_alike(best, rival)) continue;
        const Eigen::VectorXd apart = (rival.residual - best.residual).cwiseQuotient(best.spread.cwiseMax(rival.spread));
        if (apart.cwiseProduct(problem.root_weight()).norm() < inference::kSeen) places.push_back(h);
    }
    return places;
}

}  // namespace

std::vector<inference::Fit> class_rivals(const inference::Problem& problem, const inference::Search& search, const Isolability& isolability,
                                         unsigned jobs) {
    const inference::Fit& best = search.best();
    std::vector<inference::Guess> guesses;
    for (std::size_t c = 0; c < best.causes.size(); ++c) {
        const inference::Fit rest = inference::without(problem, best, c);
        for (const inference::Cause& other : inference::causes_beside(class_of(isolability, best.causes[c]), rest.causes)) {
            inference::Causes causes = rest.causes;
            causes.push_back(other);
            const auto known = [&](const auto& fit) { return inference::same_causes(fit.causes, causes); };
            if (std::none_of(search.fits.begin(), search.fits.end(), known) && std::none_of(guesses.begin(), guesses.end(), known))
                guesses.push_back(inference::guess_upon(problem, rest, other));
        }
    }
    return fits_of(problem, guesses, jobs);
}

std::vector<std::size_t> indistinct(const inference::Problem& problem, const inference::Search& search, unsigned jobs) {
    if (!problem.model().knows_usual_sizes()) return coinciding(problem, search);
    std::vector<std::size_t> open, alike;
    std::vector<const inference::Fit*> fits{&search.best()};
    for (std::size_t h = 1; h < search.fits.size() && fits.size() < inference::kMostRivals; ++h) {
        const bool apart = differs_by_side(problem, search, h);
        if (apart) alike.push_back(h);
        if (apart || !is_open(search, h)) continue;
        open.push_back(h);
        fits.push_back(&search.fits[h]);
    }
    if (open.empty() || search.best().causes.empty()) return alike;
    const std::vector<double> bits = most_bits_against_first(problem, fits, jobs);
    for (std::size_t i = 0; i < bits.size(); ++i)
        if (bits[i] < inference::kWorthwhile) alike.push_back(open[i]);
    return alike;
}

}  // namespace fusee::diagnosis
