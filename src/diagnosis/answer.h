#pragma once
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/search.h"
#include "fusee/inference/splits.h"
#include "verdict.h"

namespace fusee::diagnosis {

/// Puts a diagnosis together, part by part.
class Answer {
public:
    Answer(const inference::Problem& problem, const inference::Search& found, const Verdict& verdict);
    /// How far the gap shrinks: on the rows of the fit and on rows held out.
    void compare(const inference::Split& kept);
    /// The ranking and the intervals, which experiments that are left out may widen.
    void rank();
    /// What these experiments can tell apart, and what further one would split the rivals.
    void plan_next_experiment(unsigned jobs);
    [[nodiscard]] Diagnosis take() { return std::move(diagnosis_); }

private:
    void found_effects();
    void build();
    void traces();

    const inference::Problem& problem_;
    const inference::Search& found_;
    const Verdict& verdict_;
    joint_model::Signals nominal_;  ///< what the nominal rig gives
    Eigen::VectorXd sigma_;         ///< with build tolerances, of each row
    Eigen::VectorXd before_;        ///< (measured - nominal)/sigma
    Diagnosis diagnosis_;
};

}  // namespace fusee::diagnosis
