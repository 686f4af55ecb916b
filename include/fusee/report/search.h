#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/search/design.h"

/// A design found by a search as files for programs (JSON, CSV) and people (HTML) (docs/guides/design-springs.md).
namespace fusee::report {

using search::codesign::CamCurve, search::codesign::ComparedFigure, search::codesign::CostCurve, search::codesign::LawCurves,
    search::codesign::SearchedVariable, search::codesign::SearchReport;

/// The keys of docs/guides/design-springs.md, in that order; a NaN is null.
[[nodiscard]] std::string search_json(const SearchReport& report);
/// One page in one file that opens offline: its scripts inside, no request. @param summary for a reader without scripts
[[nodiscard]] std::string search_html(const SearchReport& report, const std::string& summary);
/// variable,value,cost,feasible (1 or 0) with 17 digits: the curves of figure 9.
[[nodiscard]] std::string figure_9_csv(const std::vector<CostCurve>& costs);
/// generation,best_cost with 17 digits; generation 0 is the first population.
[[nodiscard]] std::string history_csv(const std::vector<double>& history);

/// Writes the profiles found and their reports: design.json, design.html, history.csv and, of Algorithm 1, figure_9.csv; or pareto.json,
/// pareto.csv and pareto.html. @throws core::IoError
void write_search(const search::codesign::RunResult& result, const std::filesystem::path& folder);

}  // namespace fusee::report
