#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/paper/paper.h"
#include "fusee/report/identification.h"
#include "fusee/report/search.h"
#include "fusee/report/simulation.h"

/// The paper's tables and figures as files for programs (JSON, CSV) and people (HTML, text) (docs/guides/paper.md).
namespace fusee::report {

using paper::HillFigure, paper::NoiseCurve, paper::Paper, paper::PaperTable;

/// One line of the overview: the paper's statement, and the result here.
struct PaperClaim {
    std::string piece;  ///< "figure 1"
    std::string paper, here;
};
[[nodiscard]] std::vector<PaperClaim> claims(const Paper& paper);

/// Columns of the CSV files: docs/guides/paper.md; 17 digits.
[[nodiscard]] std::string figure_1_csv(const std::vector<NoiseCurve>& curves);
[[nodiscard]] std::string figure_2_csv(const HillFigure& figure);
[[nodiscard]] std::string figure_2_passive_csv(const HillFigure& figure);
[[nodiscard]] std::string figure_6_csv(const ReleasePath& path);
[[nodiscard]] std::string figure_8_csv(const Identification& identification);
[[nodiscard]] std::string figure_9_springs_csv(const LawCurves& law);
[[nodiscard]] std::string figure_9_arms_csv(const std::vector<CamCurve>& cams);
[[nodiscard]] std::string table_csv(const PaperTable& table);
/// The keys of docs/guides/paper.md, in that order; a NaN is null.
[[nodiscard]] std::string paper_json(const Paper& paper);
/// One page in one file that opens offline: its scripts inside, no request.
[[nodiscard]] std::string paper_html(const Paper& paper);
/// Writes paper.html, paper.json and the CSV file of each figure and table. @throws core::IoError
void write_paper(const Paper& paper, const std::filesystem::path& folder);
/// The overview for a terminal.
[[nodiscard]] std::string paper_text(const Paper& paper);

}  // namespace fusee::report
