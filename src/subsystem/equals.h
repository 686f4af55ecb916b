#pragma once
#include <string>
#include <vector>

#include "study.h"

/// Sets of effects that predict the rows as well as the answer does.
namespace fusee::subsystem {

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
