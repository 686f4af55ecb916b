#pragma once
#include <string>

#include "fusee/search/design_report.h"

/// A front of designs as files for programs (CSV, JSON) and people (HTML) (docs/guides/co-design.md).
namespace fusee::report {

using search::codesign::ParetoPoint, search::codesign::ParetoReport;

/// profile,figure_deg,dead_band_at_X_Nm_deg...,travel_rad,soft_Nm_per_rad,stiff_Nm_per_rad,radius_mm,capstan_radius_mm with 17 digits.
[[nodiscard]] std::string pareto_csv(const ParetoReport& report);
/// The keys of docs/guides/co-design.md, in that order; a NaN is null.
[[nodiscard]] std::string pareto_json(const ParetoReport& report);
/// One page in one file that opens offline: the front as a picture, a table of its designs, what limits each.
/// @param summary for a reader without scripts
[[nodiscard]] std::string pareto_html(const ParetoReport& report, const std::string& summary);

}  // namespace fusee::report
