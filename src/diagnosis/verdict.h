#pragma once
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/search.h"

namespace fusee::diagnosis {

/// What the ranking, the splits and what is left come to.
struct Verdict {
    VerdictKind verdict = VerdictKind::kNone;
    std::vector<std::string> remarks;
};
[[nodiscard]] Verdict judge(const inference::Problem& problem, const inference::Search& search);

}  // namespace fusee::diagnosis
