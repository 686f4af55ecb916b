#pragma once
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/solid/part.h"

namespace fusee::report {

/// A finding's place on the drawing with the number that it has in the table.
struct Marker {
    int number = 0;
    core::Severity severity = core::Severity::kPass;
    double x_mm = 0.0, y_mm = 0.0;
    std::string title;
};

/// The cam seen from +z in its body frame, to scale: the drawing's unit is the millimetre, and so is the size that it asks for (the page
/// shows it larger: hence the scale bar). Shows the saw cuts under the top face (flange, bore, holes) and through the boss, both of the
/// exported mesh, the pitch curve with its working arc, the groove's floor, the cable at both ends of the law, and the markers. A helix
/// shows as the spiral that it is from above.
[[nodiscard]] std::string cam_svg(const solid::Part& part, const std::vector<Marker>& markers);

}  // namespace fusee::report
