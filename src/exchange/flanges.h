#pragma once
#include "fusee/solid/part.h"

namespace fusee::exchange {

/// How far a part's flanges stand beyond the groove's lips, as the exports need it [mm].
struct FlangeReach {
    double lip = 0.0;          ///< offset of the lips from the cable's centreline
    double lower = 0.0;        ///< lower flange beyond the lips
    double upper = 0.0;        ///< upper flange beyond the lips
    double core_radius = 0.0;  ///< circle about the axis that the lower flange holds; 0 = none
};
[[nodiscard]] FlangeReach flange_reach(const solid::Part& part);

/// Outline of the upper flange, one point for each column: the parallel of the pitch curve (planar) or a circle (helix).
[[nodiscard]] std::vector<std::array<double, 2>> upper_outline(const solid::Part& part);

/// Radius of the circle that holds a helix [mm]: the farthest point of its skin.
[[nodiscard]] double helix_radius_mm(const solid::Part& part);

}  // namespace fusee::exchange
