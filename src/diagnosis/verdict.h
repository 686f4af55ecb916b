#pragma once
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/search.h"

namespace fusee::diagnosis {

/// What the ranking, the splits and what is left come to.
struct Judgement {
    Verdict verdict = Verdict::kNone;
    std::vector<std::string> remarks;
};
[[nodiscard]] Judgement judge(const inference::Problem& problem, const inference::Search& search);

}  // namespace fusee::diagnosis
