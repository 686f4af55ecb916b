#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "data/json.h"
#include "fusee/cam/arm.h"
#include "fusee/cam/cam.h"
#include "fusee/core/units.h"
#include "fusee/design/budget.h"
#include "fusee/pipeline/as_exported.h"
#include "fusee/solid/part.h"
#include "fusee/spring/law.h"

/// Curves and outlines of a design, as several JSON files hold them (docs/report.md).
/// The elongation of a cable at one load, with the same figures in every report.
namespace fusee::report {

using pipeline::AsExported, pipeline::ExportedSpring, pipeline::JointAsExported;

/// `as_exported` of report.json (docs/report.md).
[[nodiscard]] nlohmann::ordered_json as_exported_json(const AsExported& exported);

/// The page of a design. @param json its report_json
[[nodiscard]] std::string report_page(const pipeline::DesignReport& design, std::string json);

/// Key figures of a cam.
struct CamFigures {
    double travel = 0.0;  ///< cam rotation over the law [rad]
    core::Range arms_mm;
    core::Range tensions;       ///< cable [N]
    core::Range states;         ///< of the base spring [rad] or [m]
    double least_rho_mm = 0.0;  ///< radius of curvature of the pitch curve on the working arc
};
/// @pre cam.working is not empty
[[nodiscard]] CamFigures measure(const cam::Cam& cam);

/// Both springs by columns: tau_Nm, theta_rad, f_se_Nm, f_pe_Nm, s_Nm_per_rad, p_Nm_per_rad.
[[nodiscard]] Json spring_curves_json(const std::vector<spring::LawPoint>& samples);

/// The cam from +z in its body frame [mm]: sections of the exported mesh just below the top face and through the boss, the pitch curve with
/// its working arc, the groove's floor, and the cable or roller at both ends of the law. A line is the text "x,y x,y ...".
[[nodiscard]] Json drawing_json(const solid::Part& part);

/// Lengths of bands and sigmas in percent and degrees, as their names say.
[[nodiscard]] Json budget_to_json(const design::budget::Budget& budget);

/// load_Nm, tension_N, length_mm, capstan_rad, capstan_travel_rad, share.
[[nodiscard]] nlohmann::ordered_json stretch_json(const cam::ArmPoint& at);
/// "0.5 mm at 180 N: 1.9 of the capstan's 57.3 deg, 3.3 %"
[[nodiscard]] std::string stretch_text(const cam::ArmPoint& at);

}  // namespace fusee::report
