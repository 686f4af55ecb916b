#pragma once
#include <optional>
#include <vector>

#include "fusee/diagnosis/diagnose.h"
#include "fusee/inference/splits.h"
#include "standing.h"
#include "verdict.h"

namespace fusee::diagnosis {

/// What the stages of a diagnosis found: fit and search, generic terms, effects that stand, what the rows can show, the decision, held-out
/// rows, the plan. Each is made from those before it, and none is changed later.
struct Stages {
    inference::Search found;
    std::optional<inference::FoundTerms> terms;
    std::optional<Standing> part;  ///< sought where neither the best hypothesis nor terms explain the gap
    Isolability isolability;
    Decision decision;
    inference::Split held_out;  ///< of the fit that is shown
    std::optional<Absorption> absorption;
    std::vector<NextExperiment> next;  ///< best first

    [[nodiscard]] const inference::Fit& null() const { return found.fits[found.null]; }
    /// The fit that build, gap and traces are of.
    [[nodiscard]] const inference::Fit& shown() const;
};

/// All stages in their order.
[[nodiscard]] Stages stages_of(const inference::Problem& problem, const DiagnoseOptions& options);

/// The size of each effect of a fit with its interval; experiments left out may widen it.
[[nodiscard]] std::vector<Parameter> sizes_of(const inference::Problem& problem, const inference::Fit& fit,
                                              const inference::Split& left_out);

/// Further measurements: those that distinguish the rivals, or that show what these rows do not. @pre all stages before it
[[nodiscard]] std::vector<NextExperiment> plan(const inference::Problem& problem, const Stages& stages, unsigned jobs);

/// The stages in the words and units of the reader. @pre all stages
[[nodiscard]] Diagnosis answer_of(const Subject& subject, const inference::Problem& problem, const Stages& stages);

/// Measured values and predictions of every experiment. @param before of the nominal model @param after of the shown fit
[[nodiscard]] std::vector<Trace> traces_of(const inference::Problem& problem, const inference::Outputs& before,
                                           const inference::Outputs& after);

}  // namespace fusee::diagnosis
