#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/constants.h"
#include "fusee/inference/pursue.h"
#include "fusee/inference/search.h"

namespace fusee::diagnosis {

/// What the ranking, the splits and the remaining gap say of the best hypothesis.
struct Scrutiny {
    std::vector<std::string> remarks;
    bool unexplained = false;                  ///< it cannot be the answer
    bool evidence = false;                     ///< an experiment can be predicted row by row
    bool rivalled = false;                     ///< another hypothesis is too likely for a sure answer, or nothing distinguishes one from it
    std::vector<std::size_t> indistinct = {};  ///< places of the latter in the ranking
    /// It, or one that it does not exceed enough, may be named.
    [[nodiscard]] bool holds() const { return !unexplained && evidence; }
};
[[nodiscard]] Scrutiny scrutinize(const inference::Problem& problem, const inference::Search& search, unsigned jobs);

/// Generic terms where the library explains nothing, or only several of its effects together do: one unknown effect often looks like two
/// known ones. One effect competes with the terms that resemble it. The first term has to beat every hypothesis of the library.
[[nodiscard]] std::optional<inference::FoundTerms> terms_of(const inference::Problem& problem, const inference::Search& found,
                                                            const Scrutiny& scrutiny, unsigned jobs);

/// The fit that the answer's build, gap and traces are of.
enum class Shown {
    kNull,  ///< build tolerances alone: no effect is named
    kBest,  ///< the best hypothesis: its effects are named
    kPart,  ///< the effects that stand although they do not explain everything (standing.h)
    kTerms  ///< the generic terms
};

/// The verdict, with all that depends on it. It is decided once, and nothing after it changes it.
struct Decision {
    VerdictKind verdict = VerdictKind::kNone;
    Shown shown = Shown::kNull;
    std::vector<std::string> remarks;
    std::vector<Power> power;              ///< where no effect was found and nothing else speaks against that
    std::vector<std::size_t> indistinct;   ///< places in the ranking of what nothing distinguishes from the best: the verdict is ambiguous
    std::vector<inference::Cause> unseen;  ///< causes of which a usual size would have stayed unseen: the verdict is inconclusive
};
[[nodiscard]] Decision decide(const inference::Problem& problem, const inference::Search& search, const Scrutiny& scrutiny,
                              const std::optional<inference::FoundTerms>& terms, bool part_stands, const Isolability& isolability);

}  // namespace fusee::diagnosis
