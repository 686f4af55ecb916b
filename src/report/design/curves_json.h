#pragma once
#include <vector>

#include "data/json.h"
#include "fusee/solid/part.h"
#include "fusee/spring/law.h"

/// Curves and outlines of a design, as several JSON files hold them (docs/report.md).
namespace fusee::report {

/// Both springs by columns: tau_Nm, theta_rad, f_se_Nm, f_pe_Nm, s_Nm_per_rad, p_Nm_per_rad.
[[nodiscard]] Json spring_curves_json(const std::vector<spring::LawPoint>& samples);

/// The cam from +z in its body frame [mm]: sections of the exported mesh just below the top face and through the boss, the pitch curve with
/// its working arc, the groove's floor, and the cable or roller at both ends of the law. A line is the text "x,y x,y ...".
[[nodiscard]] Json drawing_json(const solid::Part& part);

}  // namespace fusee::report
