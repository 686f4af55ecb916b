#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fusee/actuator/dead_band.h"
#include "fusee/cam/arm.h"
#include "fusee/core/finding.h"
#include "fusee/core/provenance.h"
#include "fusee/core/units.h"
#include "fusee/solid/part.h"
#include "fusee/spring/law.h"

/// What a search for springs found, to files that a program (JSON, CSV) or a person (HTML) reads (docs/guides/design-springs.md).
namespace fusee::report {

/// A searched number and what became of it.
struct SearchedVariable {
    std::string name, unit;
    core::Range box;
    double found = 0.0;
    double own = std::numeric_limits<double>::quiet_NaN();  ///< of the profile's own law; NaN: it has none
};

/// A figure of the design found beside that of the profile's own.
struct ComparedFigure {
    std::string name, unit;
    double found = 0.0, own = std::numeric_limits<double>::quiet_NaN();
};

/// One picture of the paper's figure 9: the cost over one variable.
struct CostCurve {
    std::string variable, unit;
    std::vector<double> value, cost;         ///< the other variables at the optimum
    std::vector<bool> feasible;              ///< false: of the first stage
    std::vector<double> tried, lowest_cost;  ///< of all designs that the search tried, by parts of the box; NaN: none there
    double optimum = 0.0;
};

/// The springs of one design.
struct LawCurves {
    std::vector<spring::LawPoint> samples;      ///< by rising load
    std::vector<actuator::DeadBand> dead_band;  ///< by rising co-contraction
};

/// One cam of the design found.
struct CamCurve {
    cam::PartKind kind = cam::PartKind::kSeries;
    std::vector<cam::ArmPoint> arms;  ///< what the law asks of the profile's base spring
    std::optional<solid::Part> part;  ///< none: it cannot be cut, and `findings` say why
    core::Findings findings;
};

struct SearchReport {
    core::Provenance provenance;
    std::string method;  ///< "algorithm_1", ...
    int population = 0, generations = 0, seed = 0;
    std::size_t evaluations = 0;
    bool interrupted = false;
    double cost = 0.0;
    std::vector<SearchedVariable> variables;
    std::vector<ComparedFigure> figures;
    std::vector<double> history;  ///< best cost of the first population and after each generation
    std::vector<CostCurve> costs;
    LawCurves found, own;
    std::vector<CamCurve> cams;
    core::Findings findings;           ///< of the law found
    std::vector<std::string> remarks;  ///< sentences
};

/// The keys of docs/guides/design-springs.md, in that order; a NaN is null.
[[nodiscard]] std::string search_json(const SearchReport& report);
/// One page in one file that opens offline: no script, no request.
[[nodiscard]] std::string search_html(const SearchReport& report);
/// variable,value,cost,feasible (1 or 0) with 17 digits: the curves of figure 9.
[[nodiscard]] std::string figure_9_csv(const std::vector<CostCurve>& costs);
/// generation,best_cost with 17 digits; generation 0 is the first population.
[[nodiscard]] std::string history_csv(const std::vector<double>& history);

}  // namespace fusee::report
