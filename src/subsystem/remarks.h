#pragma once
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "study.h"

/// Sentences beside the verdict of a subsystem case.
namespace fusee::subsystem {

[[nodiscard]] std::vector<effects::Cause> causes_of(const Law& law, const Candidate& candidate);

/// Adds them, and how far the answer transfers: what was chosen, what the rows do not distinguish, what remains and where, the floor, the
/// error of each split. @pre the gap and its map are filled
void put_remarks(const Law& law, const Study& study, diagnosis::Diagnosis& out);

}  // namespace fusee::subsystem
