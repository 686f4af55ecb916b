#pragma once
#include "study.h"

namespace fusee::subsystem {

/// What each effect alone and the answer, fitted on the other files, do on each held-out file (each law's files, if several have one law).
/// Empty unless Law::each_fold, and with one file. @pre the study is judged
[[nodiscard]] std::vector<diagnosis::Transfer> transfers_of(const Law& law, const Study& study);

/// One sentence for each set of effects that `transfer` holds: false causes, then those of the answer, then the others.
[[nodiscard]] std::vector<std::string> transfer_remarks(const Law& law, const std::vector<diagnosis::Transfer>& transfer,
                                                        const std::vector<effects::Cause>& answer);

}  // namespace fusee::subsystem
