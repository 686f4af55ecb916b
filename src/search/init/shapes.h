#pragma once

#include "codesign/shape.h"
#include "fusee/cam/arm.h"
#include "fusee/core/finding.h"
#include "fusee/search/init.h"

namespace fusee::search::init {

/// The least radius of the contour of one part, over every size, preload, capstan and law that the search tries: a necessary condition,
/// found from contacts alone. The other part, rules and springs are not asked.
struct LeastContour {
    double radius = 0.0;  ///< of the cable's centreline [m]; infinite: no contour is convex, bends the cable so little and has one turn
    double rho = 0.0;     ///< least radius of curvature of the best contour [m]
    double wrap = 0.0;    ///< [rad]
};
[[nodiscard]] LeastContour least_contour(cam::PartKind part, const Answers& answers, unsigned jobs);

/// How far a contour misses the bend of the cable, one turn and the radius that answers allow, as shares of them; 0: nowhere.
/// @param margin on the bend
[[nodiscard]] double broken_share(const codesign::Shape& shape, const Answers& answers, double margin);

/// "limit.contour_radius", "limit.rho", "limit.wrap": what the least contours of both parts break; empty: nothing.
[[nodiscard]] core::Findings broken_contours(const Answers& answers, unsigned jobs);

}  // namespace fusee::search::init
