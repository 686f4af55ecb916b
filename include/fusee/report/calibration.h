#pragma once
#include <string>

#include "fusee/coupon/calibration.h"

namespace fusee::report {

/// What a sheet of coupons said.
struct CalibrationReport {
    std::string name;         ///< of the sheet
    std::string file_sha256;  ///< of its bytes
    coupon::Calibration calibration;
};

/// Keys as docs/guides/calibrate.md gives them; SI, a NaN is null.
[[nodiscard]] std::string calibration_json(const CalibrationReport& report);
/// A table, what cannot be known, and the lines of a profile.
[[nodiscard]] std::string calibration_text(const CalibrationReport& report);

}  // namespace fusee::report
