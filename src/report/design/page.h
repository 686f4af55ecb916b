#pragma once
#include <string>
#include <vector>

#include "design/cam_drawing.h"
#include "fusee/report/report.h"

/// The sections of report.html, each a pure function of its data.
namespace fusee::report {

/// A finding with its number in the page; `part` is "law" or the part's name.
struct NumberedFinding {
    int number = 0;
    std::string part;
    core::Finding finding;
};
/// Errors first, numbered in that order.
[[nodiscard]] std::vector<NumberedFinding> ranked(std::vector<NumberedFinding> findings);
/// All findings, ranked.
[[nodiscard]] std::vector<NumberedFinding> numbered(const DesignReport& design);
[[nodiscard]] std::vector<Marker> markers_of(const std::vector<NumberedFinding>& findings, const std::string& part);

[[nodiscard]] std::string law_section(const DesignReport& design);
/// Rows of a measured table and the springs smoothed from it; empty for other laws.
[[nodiscard]] std::string table_section(const LawReport& law);
[[nodiscard]] std::string dead_band_section(const DesignReport& design);
[[nodiscard]] std::string part_section(const PartReport& part, const std::vector<Marker>& markers);
/// Errors, warnings and rules that were not judged, each with a link to its place.
[[nodiscard]] std::string findings_section(const std::vector<NumberedFinding>& findings);
/// Rules that passed, folded.
[[nodiscard]] std::string passed_section(const std::vector<NumberedFinding>& findings);
[[nodiscard]] std::string read_back_section(const DesignReport& design);
[[nodiscard]] std::string files_section(const DesignReport& design);

}  // namespace fusee::report
