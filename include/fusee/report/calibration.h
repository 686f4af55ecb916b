#pragma once
#include <string>

#include "fusee/pipeline/coupons.h"

namespace fusee::report {

using pipeline::CalibrationReport;

/// Keys as docs/guides/calibrate.md gives them; SI, a NaN is null.
[[nodiscard]] std::string calibration_json(const CalibrationReport& report);
/// A table, the figures that cannot be known, and the lines of a profile.
[[nodiscard]] std::string calibration_text(const CalibrationReport& report);

}  // namespace fusee::report
