#pragma once
#include <span>
#include <vector>

#include "fusee/inference/constants.h"
#include "fusee/inference/fit.h"

namespace fusee::inference {

/// A hypothesis with approximate parameters.
struct Guess {
    Causes causes;
    Eigen::VectorXd x;
    double cost = 0.0;  ///< estimated: build parameters follow in the linear model
};

/// Every effect of the model on every side; the generic ones instead, if `generic`.
[[nodiscard]] std::vector<Cause> causes_of(const Model& model, bool generic = false);
/// Those of them that the experiments of the case can see.
[[nodiscard]] std::vector<Cause> possible_causes(const Problem& problem, bool generic = false);

/// Those of `causes` that may join `base`: of another effect, or of one of its effects on the other side, which then has a size of its own.
[[nodiscard]] std::vector<Cause> causes_beside(std::vector<Cause> causes, const Causes& base);

/// The same causes in any order.
[[nodiscard]] bool same_causes(const Causes& a, const Causes& b);

/// A fit without causes[c], where it is: not fitted again.
[[nodiscard]] Fit without(const Problem& problem, const Fit& fit, std::size_t c);
/// A fit without causes[c], fitted again from where it is.
[[nodiscard]] Fit refit_without(const Problem& problem, const Fit& fit, std::size_t c, unsigned jobs);

/// Adds `cause` to what `base` has, fitted to the rows `kept` in a few steps from the best of its starts; the parameters of `base` follow
/// in its linear model. No row that is not kept is looked at.
[[nodiscard]] Guess guess_upon(const Problem& problem, const Fit& base, const Cause& cause, const std::vector<bool>* kept = nullptr);

/// Adds each of `causes` to what `base` has, at its sizes to start with and one Gauss-Newton step, the rest of x following in
/// the linear model of `base`. Sorted by cost.
/// @param improved only the best so many make the step
[[nodiscard]] std::vector<Guess> screen(const Problem& problem, const Fit& base, const std::vector<Cause>& causes, unsigned jobs,
                                        std::size_t improved = static_cast<std::size_t>(-1));

/// Cost of the rows of direct experiments at each guess, which needs no simulation; 0 if there are none.
[[nodiscard]] std::vector<double> direct_costs(const Problem& problem, const std::vector<Guess>& guesses, unsigned jobs);

/// Full fits of guesses, in their order. They share the threads.
[[nodiscard]] std::vector<Fit> fits_of(const Problem& problem, std::span<const Guess> guesses, unsigned jobs);

}  // namespace fusee::inference
