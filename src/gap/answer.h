#pragma once
#include "fusee/gap/diagnosis.h"
#include "search.h"
#include "splits.h"
#include "verdict.h"

namespace fusee::gap {

/// Puts a diagnosis together, part by part.
class Answer {
public:
    Answer(const Problem& problem, const Search& found, const Judgement& judgement);
    /// How far the gap shrinks: on the rows of the fit and on rows kept back.
    void compare(const Split& kept);
    /// The ranking and the intervals, which experiments that are left out may widen.
    void rank();
    /// What these experiments can tell apart, and what further one would split the rivals.
    void look_ahead(unsigned jobs);
    [[nodiscard]] Diagnosis take() { return std::move(diagnosis_); }

private:
    void found_effects();
    void build();
    void traces();

    const Problem& problem_;
    const Search& found_;
    const Judgement& judgement_;
    Signals nominal_;         ///< what the nominal rig gives
    Eigen::VectorXd sigma_;   ///< with build tolerances, of each row
    Eigen::VectorXd before_;  ///< (measured - nominal)/sigma
    Diagnosis diagnosis_;
};

}  // namespace fusee::gap
