#pragma once
#include <string>

#include "fusee/gap/diagnosis.h"
#include "page/html.h"

/// The parts of the diagnosis page, each pure HTML from data and "" where there is nothing to show.
namespace fusee::report {

/// @param title plain text
[[nodiscard]] std::string section(const std::string& title, const std::string& content);
/// A share of 1 as a bar with its figure beside it.
[[nodiscard]] Cell share_cell(double share, const std::string& text);

[[nodiscard]] std::string where_section(const gap::Diagnosis& diagnosis);        ///< parts of the gap, map before and after
[[nodiscard]] std::string which_section(const gap::Diagnosis& diagnosis);        ///< effects found, what else could be, ranking
[[nodiscard]] std::string isolability_section(const gap::Diagnosis& diagnosis);  ///< likeness, classes, detectable sizes
[[nodiscard]] std::string how_far_section(const gap::Diagnosis& diagnosis);      ///< gap of each experiment, fitted and kept back
[[nodiscard]] std::string trace_section(const gap::Diagnosis& diagnosis);        ///< measured against predicted

inline constexpr std::size_t kMostPointsOfATrace = 400, kMostDotsOfATrace = 120;
inline constexpr std::size_t kMostPoints = 12000;  ///< of all traces together: at about 100 bytes each the page stays below 2 MB
/// How many points of each of `traces` traces are drawn.
[[nodiscard]] std::size_t drawn_points(std::size_t traces);

}  // namespace fusee::report
