#include "rivals.h"

#include <algorithm>
#include <cmath>

#include "fusee/inference/constants.h"
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

/// The rows see less than 3 sigma of difference, or the ranking leaves it a chance that is worth an experiment.
bool is_open(const inference::Search& search, std::size_t h) {
    const inference::Fit &best = search.best(), &rival = search.fits[h];
    if (rival.causes.empty()) return false;
    const bool seen_alike =
        rival.causes.size() == best.causes.size() && std::abs(rival.cost - best.cost) < inference::kSeen * inference::kSeen;
    return seen_alike || search.probability[h] >= inference::kSmallLeak;
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
    std::vector<std::size_t> open;
    std::vector<const inference::Fit*> fits{&search.best()};
    for (std::size_t h = 1; h < search.fits.size() && fits.size() < inference::kMostRivals; ++h) {
        if (!is_open(search, h)) continue;
        open.push_back(h);
        fits.push_back(&search.fits[h]);
    }
    if (open.empty() || search.best().causes.empty()) return {};
    const std::vector<double> bits = most_bits_against_first(problem, fits, jobs);
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < bits.size(); ++i)
        if (bits[i] < inference::kWorthwhile) alike.push_back(open[i]);
    return alike;
}

}  // namespace fusee::diagnosis
