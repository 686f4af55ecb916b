#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/search/design.h"
#include "fusee/search/design_report.h"
#include "fusee/search/fix.h"
#include "fusee/search/init.h"
#include "fusee/search/one_spring.h"
#include "fusee/search/redesign.h"

/// What the searches found, as files for programs (JSON, CSV) and people (HTML), and as lines for a terminal.
namespace fusee::report {

// Springs found by a search (docs/guides/design-springs.md).

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

// A front of designs (docs/guides/co-design.md).

using search::codesign::ParetoPoint, search::codesign::ParetoReport;

/// profile,figure_deg,dead_band_at_X_Nm_deg...,travel_rad,soft_Nm_per_rad,stiff_Nm_per_rad,radius_mm,capstan_radius_mm with 17 digits.
[[nodiscard]] std::string pareto_csv(const ParetoReport& report);
/// The keys of docs/guides/co-design.md, in that order; a NaN is null.
[[nodiscard]] std::string pareto_json(const ParetoReport& report);
/// One page in one file that opens offline: the front as a picture, a table of its designs, what limits each.
/// @param summary for a reader without scripts
[[nodiscard]] std::string pareto_html(const ParetoReport& report, const std::string& summary);

// The changes that a profile needs so that it can be made (docs/guides/fix.md).

using search::fix::Fix, search::fix::LostTorque, search::fix::MadeChange;
using FixConflict = search::fix::Conflict;

/// Keys as docs/guides/fix.md gives them.
[[nodiscard]] std::string fix_json(const Fix& fix);
/// Lines for a terminal.
[[nodiscard]] std::string fix_text(const Fix& fix);

// A first profile.

/// The result of `fusee init` for a terminal: what was chosen and the next commands, or the binding limits and the nearest change.
/// @param file as the user named it @param more options that are no answers, for a command that is to be given again: " --yes"
[[nodiscard]] std::string init_text(const search::init::Result& result, const std::string& file, const std::string& more = "");

/// Dead-band, sizes, outside torque, springs and material of a design, before it is written, and the law that was changed.
/// @pre result.design
[[nodiscard]] std::string init_summary(const search::init::Result& result);

/// The binding limits, and the changes of a single answer that meet them.
[[nodiscard]] std::string init_refusal(const search::init::Result& result);

// The consequences of a diagnosis for the cams (docs/guides/close-the-loop.md).

using profile::Edit, search::redesign::DeadBandWidths, search::redesign::NotMended, search::redesign::Redesign;
using RedesignCover = search::redesign::Cover;
using RedesignLevel = search::redesign::Level;
using RedesignProfile = search::redesign::CorrectedProfile;

/// Keys as docs/guides/close-the-loop.md gives them; a NaN is null.
[[nodiscard]] std::string redesign_json(const Redesign& redesign);
/// "covers 0.9 to 1.31 Nm of the 0.85 to 1.5 Nm in use: ..."; "" if it is not known.
[[nodiscard]] std::string coverage(const RedesignCover& cover);
/// A few lines for a terminal.
[[nodiscard]] std::string redesign_text(const Redesign& redesign);

// Families of a single spring (docs/guides/one-spring.md).

/// The families of a single spring as a table: diameter and height of the part, its volume and that of its spring, torque error as built,
/// stress and fatigue of the wire; or the limit that binds. Then the changed law, or what would have to change. @param may_repair names
/// the option --repair where no part was found
[[nodiscard]] std::string families_text(const std::string& name, const std::vector<search::one_spring::Family>& families, bool may_repair);
/// The fronts of all families, a row each part.
[[nodiscard]] std::string fronts_csv(const std::vector<search::one_spring::Family>& families);
/// The families as a JSON array.
[[nodiscard]] std::string families_json(const std::vector<search::one_spring::Family>& families);

}  // namespace fusee::report
