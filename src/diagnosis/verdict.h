#pragma once
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/search.h"

namespace fusee::diagnosis {

inline constexpr double kSure = 0.75;  ///< probability from which one hypothesis is the answer

/// Result of ranking, splits and remaining gap.
struct Verdict {
    VerdictKind verdict = VerdictKind::kNone;
    std::vector<std::string> remarks;
};
[[nodiscard]] Verdict judge(const inference::Problem& problem, const inference::Search& search);

}  // namespace fusee::diagnosis
