#pragma once
#include <optional>
#include <vector>

#include "fusee/inference/fit.h"
#include "fusee/inference/screen.h"

namespace fusee::inference {

/// Columns of the residual by the first parameters of x, then by the others.
[[nodiscard]] Eigen::MatrixXd joined(const Eigen::MatrixXd& first, const Eigen::MatrixXd& others);

/// The least cost first; those without one last.
void sort_by_cost(std::vector<Guess>& guesses);

struct DescendOptions {
    int steps = 12;          ///< at most
    double least = 0.01;     ///< it ends with a step that lowers the cost by no more
    double smallest = 0.05;  ///< share of a step that is tried
};
/// Gauss-Newton steps from `start.x` that lower the cost (eq. 10) on the rows `kept`, each tried in full, then at ever smaller shares.
/// Predictions have one dead-band repeat per level. The columns of the first parameters are held, those of the others are taken at every
/// step.
/// @param spread of each row
/// @param held   is left as it was last
[[nodiscard]] Guess descend(const Problem& problem, const Eigen::VectorXd& spread, HeldSlopes& held, Guess start,
                            const DescendOptions& options, const std::vector<bool>* kept = nullptr);

/// A fit that strains a build parameter beyond what a workshop causes is tried again with such parameters at 0: they had replaced what
/// its causes explain now. @return the likelier one
[[nodiscard]] Fit relaxed(const Problem& problem, Fit found, unsigned jobs);

/// The likeliest fit of the same causes from other starts: build parameters at 0, each further parameter of a cause (of a simulator its
/// size, too) where it is, kNeighbour times as large or as small. Friction that sticks has local minima where a parameter stops, and an
/// effect too many would mend.
[[nodiscard]] Fit restarted(const Problem& problem, Fit found, unsigned jobs);

/// A fit whose causes are looked for once more, one after the other, now that all else is where it belongs: laws over an angle and
/// friction that sticks have many local minima. It ends where nothing is left to explain. @return the likeliest one
[[nodiscard]] Fit searched_again(const Problem& problem, Fit found, unsigned jobs);

/// `base` with one of its effects on both sides in two: agonist and antagonist, each with a size of its own. Those that a few steps from
/// there make worth half of the odds of one effect more.
[[nodiscard]] std::vector<Guess> sides_apart(const Problem& problem, const Fit& base);

/// `base` with one cause more: what its most strained build parameter is beyond its tolerance, at the size of its deviation. A like strain
/// on the other side is the same cause on both. None if no parameter is beyond kMisstated, or none of those has a cause that may join.
[[nodiscard]] std::optional<Guess> restated(const Problem& problem, const Fit& base);

}  // namespace fusee::inference
