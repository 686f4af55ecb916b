#pragma once
#include "fusee/diagnosis/diagnose.h"
#include "fusee/inference/pursue.h"
#include "fusee/inference/search.h"
#include "fusee/inference/splits.h"
#include "verdict.h"

namespace fusee::diagnosis {

/// Assembles a diagnosis, part by part.
class Answer {
public:
    Answer(const Subject& subject, const inference::Problem& problem, const inference::Search& found, const Verdict& verdict);
    /// Generic terms explain the gap: the verdict is `unknown`, and all that follows is with these terms.
    void name(const inference::FoundTerms& terms);
    /// The fit that the figures of the gap are of.
    [[nodiscard]] const inference::Fit& shown() const { return *shown_; }
    /// Reduction of the gap, on the rows of the fit and on held-out rows.
    void compare(const inference::Split& kept);
    /// Ranking and intervals; experiments left out may widen the intervals.
    void rank();
    /// Isolability of the causes, the power of a verdict without effects, and the next experiment: the one that distinguishes the rivals,
    /// or that shows what these rows do not.
    void plan_next_experiment(unsigned jobs);
    [[nodiscard]] Diagnosis take() { return std::move(diagnosis_); }

private:
    void found_effects();
    void build();
    void traces();
    /// Where a usual size of some effect would stay unseen, `none` becomes `inconclusive`. @return those effects
    [[nodiscard]] std::vector<inference::Cause> weigh_power();

    const inference::Problem& problem_;
    const inference::Search& found_;
    const Verdict& verdict_;
    inference::Outputs nominal_;   ///< prediction of the nominal model
    Eigen::VectorXd sigma_;        ///< of each row, with build tolerances
    Eigen::VectorXd before_;       ///< (measured - nominal)/sigma
    const inference::Fit* shown_;  ///< the best hypothesis, or that with generic terms
    Diagnosis diagnosis_;
};

}  // namespace fusee::diagnosis
