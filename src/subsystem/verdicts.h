#pragma once
#include "study.h"

namespace fusee::subsystem {

constexpr double kLeastEvidence = 5.0;  ///< that an effect must add [nats]: 150 to 1

/// Sets `refused` if an effect of the set is not justified. @pre the sets with one effect less are in `study`
void refuse(const Law& law, const Study& study, Candidate& candidate);
/// Refuses sets and gives the others their probabilities. @pre fits, refits and evidence are in place
void judge(const Law& law, Study& study);
/// Adds remarks on effects outside the answer and on disagreeing splits.
void remark(const Law& law, Study& study);

/// "element.presliding + element.backlash"; "no effect"
[[nodiscard]] std::string name_of(const Law& law, const std::vector<std::size_t>& effects);
/// "gear.coulomb", with its side where two motors make a difference: "gear.coulomb (agonist)"
[[nodiscard]] std::string name_of(const LawEffect& effect);

}  // namespace fusee::subsystem
