#pragma once
#include "study.h"

namespace fusee::subsystem {

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

}  // namespace fusee::subsystem
