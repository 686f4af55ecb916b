#pragma once
#include <string>
#include <vector>

#include "search.h"

namespace fusee::gap {

/// What the ranking, the splits and what is left come to.
struct Judgement {
    Verdict verdict = Verdict::kNone;
    std::vector<std::string> remarks;
};
[[nodiscard]] Judgement judge(const Problem& problem, const Search& search);

}  // namespace fusee::gap
