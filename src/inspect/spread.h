#pragma once
#include <vector>

#include "fusee/inspect/body.h"

namespace fusee::inspect {

/// About `count` points: half of them in proportion to area, half to the number of triangles, so that small facets have points too. Within
/// a triangle they follow a low-discrepancy sequence. Nothing is random.
[[nodiscard]] std::vector<Sample> spread(const Body& body, std::size_t count);

}  // namespace fusee::inspect
