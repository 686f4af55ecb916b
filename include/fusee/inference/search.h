#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fusee/inference/constants.h"
#include "fusee/inference/splits.h"

namespace fusee::inference {

/// Every fully fitted hypothesis, best first by evidence and prior.
struct Search {
    std::vector<Fit> fits;
    std::vector<Split>
        left_out;  ///< of each, with experiments left out: for the likely ones of the best four and for no effect, else empty
    std::vector<double> log_posterior;  ///< of each, relative to the best [nats]
    std::vector<double> probability;    ///< sums to 1
    std::size_t null = 0;               ///< the place of the hypothesis without effects
    [[nodiscard]] const Fit& best() const { return fits.front(); }
};

/// Probabilities of hypotheses by their log scores [nats]: they sum to 1.
[[nodiscard]] std::vector<double> probabilities(std::span<const double> log_scores);
/// Another hypothesis is too likely for a sure answer. @param next the greatest probability of the others
[[nodiscard]] bool rivalled(double best, double next);

struct SearchOptions {
    unsigned jobs = 1;
    std::function<void(const std::string&)> progress;  ///< called with the name of each finished part
};

/// The place of the earlier cause whose other side causes[c] is, by a size that differs by kUnequal or more.
[[nodiscard]] std::optional<std::size_t> other_side(const Problem& problem, const Fit& fit, std::size_t c);

/// Log odds against a hypothesis by its effects (docs/theory/diagnosis.md, eq. 14) [nats]. The effect of another one on its other side
/// costs little where the sizes differ: what one side has, the other often has too.
[[nodiscard]] double odds_against(const Problem& problem, const Fit& fit);

/// True if nothing is left for a further effect: every experiment agrees within its accuracy, and no build parameter deviates enough
/// to replace one.
[[nodiscard]] bool explained(const Problem& problem, const Fit& fit);
/// True if every effect of the hypothesis is there: its size stands off 0, or it is a limit (a stop), which has no size of 0.
[[nodiscard]] bool sizes_stand(const Problem& problem, const Fit& fit);

/// Applies the cost of a contradiction to every larger hypothesis if no single effect beats none after the splits: pairs were sought for
/// a single effect, and sizes that only compensate each other are not a pair of causes.
/// @param effects how many each hypothesis has
/// @param scores  of each [nats]
void discount_unfounded(std::span<const std::size_t> effects, std::span<double> scores);

/// The same ranking with further hypotheses, as far as they stand: their places and all probabilities follow from their evidence. One that
/// is known takes the likelier fit.
[[nodiscard]] Search with_fits(const Problem& problem, Search search, std::vector<Fit> fits, unsigned jobs);

/// Tries no effect, then each effect on each side, then pairs upon the best single ones. Each is screened in the linear model, and the
/// best are fitted in full.
/// Pairs are sought only if a single effect was found; a second one must improve on the accuracy of the first. If nothing explains all,
/// the effects of the best two hypotheses are looked for once more, and a third and a fourth effect upon the best pairs: as long as each
/// pays for its odds and rows that a fit has not seen are predicted better. An effect may have different sizes on the two sides: it is two.
/// A hypothesis that the splits contradict (interval.h) needs far more evidence.
[[nodiscard]] Search search(const Problem& problem, const SearchOptions& options);

}  // namespace fusee::inference
