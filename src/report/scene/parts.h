#pragma once
#include "data/json.h"
#include "fusee/assembly/assembly.h"
#include "fusee/report/report.h"

/// The pieces of `scene_json`.
namespace fusee::report {

/// Rounded to 1e-5 of the unit, so that the text is short; NaN is null.
[[nodiscard]] double rounded(double value);
[[nodiscard]] Json vector_json(const Eigen::Vector3d& v);

/// The data of both cams: a row for each working position with angle, arm, tension, radius of curvature, contact and the rules that have a
/// value there; rules without one; the cable from the anchor to the wound end of the working arc.
[[nodiscard]] Json cam_tables_json(const DesignReport& design);

/// Each cable as a line: contact on a cam or end, places that it passes, arc on a drum.
[[nodiscard]] Json cables_json(const assembly::Assembly& assembly);

}  // namespace fusee::report
