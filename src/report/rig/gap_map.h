#pragma once
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "picture/standalone.h"

namespace fusee::report {

/// The gap of each experiment over its variable, before and after, and the legend; none without a map.
[[nodiscard]] std::vector<Figure> gap_map_figures(const std::vector<diagnosis::GapCell>& map);

}  // namespace fusee::report
