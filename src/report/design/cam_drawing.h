#pragma once
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/solid/part.h"

namespace fusee::report {

/// The place of a finding on the drawing, with its number in the table.
struct Marker {
    int number = 0;
    core::Severity severity = core::Severity::kPass;
    double x_mm = 0.0, y_mm = 0.0;
    std::string title;
};

/// View of the cam from +z in its body frame, to scale: one drawing unit is one millimetre (the page enlarges it, so it has a scale bar).
/// Shows sections of the exported mesh just below the top face and through the boss, the pitch curve with its working arc, the groove
/// floor, the cable at both ends of the law, and the markers. A helix appears as a spiral.
[[nodiscard]] std::string cam_svg(const solid::Part& part, const std::vector<Marker>& markers);

}  // namespace fusee::report
