#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fit.h"

/// All hypotheses of a subsystem case, fitted on all rows and on the rows of each split.
namespace fusee::subsystem {

/// One hypothesis: a set of effects.
struct Candidate {
    std::vector<std::size_t> effects;  ///< indices into law.effects, ascending; empty: the nominal law
    Fit fit;
    Misfit seen;                              ///< each block, by the fit on all
    std::vector<Misfit> unseen;               ///< for each scheme: each block, by the fit without it; empty: not refitted
    std::vector<std::vector<Values>> refits;  ///< for each scheme: the values of each of its fits, own parameters of held-out files too
    double log_likelihood = 0.0;              ///< of the rows, with the effective number of them [nats]
    double log_evidence = 0.0;                ///< -BIC/2: log_likelihood less priors and parameters [nats]
    std::string refused;                      ///< why it is excluded; empty: it is a candidate
    bool unlikely = false;                    ///< refused for its evidence alone
    std::optional<std::size_t> stopped = {};  ///< of a refused set: its effect whose search stopped at an end of its range
    double probability = 0.0;

    /// Root mean square over the blocks [sigma].
    [[nodiscard]] double seen_gap() const;
    [[nodiscard]] double unseen_gap(std::size_t scheme) const;
    /// Mean over all schemes.
    [[nodiscard]] double unseen_gap() const;
};

struct Study {
    std::vector<Candidate> candidates;   ///< the nominal law first
    std::vector<double> effective_rows;  ///< of each block
    std::size_t best = 0;                ///< the most probable one
    std::vector<std::size_t> equals;     ///< sets that the rows do not tell from the best one, the best first; empty: there are none
    bool hidden = false;                 ///< an effect that this case cannot show would explain the rows better
    double stability = 0.0;              ///< share of the folds whose held-out rows `best` predicts best of those not refused
    std::vector<std::string> remarks;    ///< on effects that were refused, and on splits that disagree
    std::size_t choice = 0;              ///< of law.open_input, which the rows prefer
    double choice_lead = 0.0;            ///< its evidence above that of the next choice [nats]
    core::Range heldout_after_95;        ///< of best's gap on held-out blocks [sigma]

    [[nodiscard]] const Candidate* find(std::vector<std::size_t> effects) const;
    /// The probability that an effect is in the answer.
    [[nodiscard]] double probability_of(std::size_t effect) const;
};

/// @throws core::InvalidInput if there are too few rows for the nominal parameters, or a block without any
void require_rows(const Law& law);
/// The fit of the candidate's effects on all rows: from every start, and from the best of the sets without one of the effects.
void fit_all(const Law& law, const Study& study, const Values& nominal, Candidate& candidate);
/// Its likelihood and its evidence, -BIC/2 with the scale of the residuals fitted too, but never below the floor. @pre it is fitted
void set_evidence(const Law& law, const Study& study, Candidate& candidate);

/// Sets of up to law.most_effects effects, for each choice of law.open_input; the choice of most evidence stands. An effect of a set counts
/// if, against the set without it, the evidence rises by 5 nats, the search did not stop at an end of the effect's range, the held-out gap
/// falls in every scheme (with Law::each_fold, in each half of a split in two), and over the blocks it falls by more than its standard
/// error, unless the set without it is at the floor already. The probability of the sets that are left is the mean of two: pseudo-BMA+ on
/// the held-out blocks (Y. Yao, A. Vehtari, D. Simpson, A. Gelman, Bayesian Analysis 13, 2018) and the share of folds that each predicts
/// best.
[[nodiscard]] Study study(const Law& law, const diagnosis::DiagnoseOptions& options);

/// Sets `refused` if an effect of the set is not justified. @pre the sets with one effect less are in `study`
void refuse(const Law& law, const Study& study, Candidate& candidate);
/// Refuses sets and gives the others their probabilities. @pre fits, refits and evidence are in place
void judge_candidates(const Law& law, Study& study);
/// Adds remarks on effects outside the answer and on disagreeing splits.
void remark(const Law& law, Study& study);

/// Where the search stopped: "at -0.6, an end of its range (-0.6 to 2)", of a further parameter "with stribeck_speed at 5 rad/s, ..."; ""
/// if none of the parameters is at such an end.
[[nodiscard]] std::string stopped_at(const Law& law, const std::vector<std::size_t>& parameters, const Values& values);

/// "element.presliding + element.backlash"; "no effect"
[[nodiscard]] std::string name_of(const Law& law, const std::vector<std::size_t>& effects);
/// "gear.coulomb", with its side where two motors make a difference: "gear.coulomb (agonist)"
[[nodiscard]] std::string name_of(const LawEffect& effect);

/// Finds the sets with no more effects than the best one whose likelihood is within 5 nats of it or above; each of their effects raises the
/// evidence by 5 nats, and they transfer to held-out files (parts of one file do not refuse them). Where the best set needs a nominal
/// parameter far from its plausible values, also the sets with one effect more that do not. They share their probability by evidence, the
/// first at most 0.7: they are distinguished by what is plausible, not by rows. Of equal ones, the first in the order of the effects is
/// best. Sets of any size that the evidence prefers by 5 nats and only parts of one file refuse get three tenths. Before, each probability
/// falls as the evidence is below that of the best set. Nothing unless Law::weighs_equals. @pre the sets are judged and weighed
void share_among_equals(const Law& law, Study& study);

/// Effects that some of these sets hold and others do not, ascending; empty: there are no equals.
[[nodiscard]] std::vector<std::size_t> open_effects(const Study& study);

/// What the rows do not distinguish, and nominal values that are not plausible, a sentence each.
[[nodiscard]] std::vector<std::string> equals_remarks(const Law& law, const Study& study);

}  // namespace fusee::subsystem
