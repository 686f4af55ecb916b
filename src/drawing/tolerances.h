#pragma once
#include <string>
#include <vector>

#include "badge.h"
#include "fusee/drawing/drawing.h"

namespace fusee::drawing {

/// What the drawing allows, from the process's figures (docs/rules.md, table 3).
struct Tolerances {
    double process = 0.0;                          ///< of a contour, one side [m]
    double contour = 0.0;                          ///< width of the zone of the working arc: both sides [m]
    double position = 0.0;                         ///< of key, mark and anchor hole: width or diameter of the zone [m]
    double face = 0.0;                             ///< perpendicularity of the face that locates the part [m]
    double runout = 0.0;                           ///< of the top face [m]
    double edge = 0.0;                             ///< most that is taken off an edge, or left in a corner [m]
    double roughness = 0.0, fine_roughness = 0.0;  ///< Ra in general; of bore and floor [m]
    bool removal = false;                          ///< surfaces are cut
    std::string general;                           ///< "ISO 2768-1 c"
    std::string datum_b;                           ///< what gives the part its angle: "keyway"
    bool mark_is_b = false;                        ///< nothing but the timing mark does
};
[[nodiscard]] Tolerances tolerances_of(const Subject& subject);

/// "Ra 12.5" with its symbol.
[[nodiscard]] Badge roughness_badge(const Tolerances& tolerances, double value);
inline const std::vector<std::string> kDatumA{"A"}, kDatumsAB{"A", "B"};

}  // namespace fusee::drawing
