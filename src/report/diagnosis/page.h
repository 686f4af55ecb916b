#pragma once
#include <cstddef>
#include <string>

#include "fusee/diagnosis/diagnosis.h"

/// The sections of the diagnosis page, each a pure function of its data and "" without content.
namespace fusee::report {

[[nodiscard]] std::string where_section(const diagnosis::Diagnosis& diagnosis);        ///< contributions to the gap, map before and after
[[nodiscard]] std::string which_section(const diagnosis::Diagnosis& diagnosis);        ///< effects found, alternatives, ranking
[[nodiscard]] std::string isolability_section(const diagnosis::Diagnosis& diagnosis);  ///< similarities, classes, detectable sizes
[[nodiscard]] std::string trace_section(const diagnosis::Diagnosis& diagnosis);        ///< measured against predicted

inline constexpr std::size_t kMostPointsOfATrace = 400, kMostDotsOfATrace = 120;
inline constexpr std::size_t kMostPoints = 12000;  ///< of all traces together: at about 100 bytes each the page stays below 2 MB
/// How many points of each of `traces` traces are drawn.
[[nodiscard]] std::size_t drawn_points(std::size_t traces);

}  // namespace fusee::report
