#pragma once
#include <vector>

#include "fusee/inspect/body.h"

namespace fusee::inspect {

/// About `count` places: half of them in proportion to area, half to the number of triangles, so that small facets are seen too; within a
/// triangle by a low-discrepancy sequence. Nothing is random.
[[nodiscard]] std::vector<Sample> spread(const Body& body, std::size_t count);

}  // namespace fusee::inspect
