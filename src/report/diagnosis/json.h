#pragma once
#include "data/json.h"
#include "fusee/diagnosis/diagnosis.h"

namespace fusee::report {

inline constexpr std::size_t kMostPointsOfATrace = 400;
inline constexpr std::size_t kMostPoints = 12000;  ///< of all traces together: at about 100 bytes each the page stays below 2 MB
/// How many points of each of `traces` traces the JSON holds.
[[nodiscard]] std::size_t drawn_points(std::size_t traces);

/// `traces` of diagnosis.json: evenly chosen rows of each table, with the reduction of its squared gap.
[[nodiscard]] Json traces_json(const std::vector<diagnosis::Trace>& traces);

}  // namespace fusee::report
