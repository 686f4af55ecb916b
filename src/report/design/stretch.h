#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "fusee/cam/arm.h"

/// The elongation of a cable at one load, with the same figures in every report.
namespace fusee::report {

/// load_Nm, tension_N, length_mm, capstan_rad, capstan_travel_rad, share.
[[nodiscard]] nlohmann::ordered_json stretch_json(const cam::ArmPoint& at);
/// "0.5 mm at 180 N: 1.9 of the capstan's 57.3 deg, 3.3 %"
[[nodiscard]] std::string stretch_text(const cam::ArmPoint& at);

}  // namespace fusee::report
