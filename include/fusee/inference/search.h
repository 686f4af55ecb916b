#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fusee/inference/splits.h"

namespace fusee::inference {

/// Every hypothesis that was fitted in full, best first by evidence and prior.
struct Search {
    std::vector<Fit> fits;
    std::vector<Split> left_out;        ///< of each, with experiments left out: the best four and no effect, else empty
    std::vector<double> log_posterior;  ///< of each, relative to the best [nats]
    std::vector<double> probability;    ///< sums to 1
    std::size_t null = 0;               ///< the place of the hypothesis without effects
    [[nodiscard]] const Fit& best() const { return fits.front(); }
};

struct SearchOptions {
    unsigned jobs = 1;
    std::function<void(const std::string&)> progress;  ///< of each part that is finished: five
};

/// Takes the price of a contradiction from every pair where no single effect beats none once the splits were asked: pairs were sought for
/// the sake of a single one, and sizes that only make up for each other are no pair of causes.
/// @param effects how many each hypothesis has
/// @param scores  of each [nats]
void discount_unfounded(std::span<const std::size_t> effects, std::span<double> scores);

/// No effect, then each effect on each side, then pairs upon the best single ones: screened in the linear model, the best fitted in full.
/// Pairs are sought only where a single effect was found; a second one has to pay for itself at the accuracy that the first one reached.
/// What the splits contradict (interval.h) has to be worth far more.
[[nodiscard]] Search search(const Problem& problem, const SearchOptions& options);

}  // namespace fusee::inference
