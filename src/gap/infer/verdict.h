#pragma once
#include <string>
#include <vector>

#include "search.h"

namespace fusee::gap {

/// What the ranking, the splits and what is left come to.
struct Judgement {
    Verdict verdict = Verdict::kNone;
    std::vector<std::size_t> rivals;      ///< of search.fits, for an ambiguous verdict: all that are as good; else the best alone
    std::vector<Experiment> unexplained;  ///< experiments that the best hypothesis leaves above the floor
    std::vector<std::string> remarks;
};
[[nodiscard]] Judgement judge(const Problem& problem, const Search& search);

}  // namespace fusee::gap
