#pragma once
#include <string>

#include "fusee/core/units.h"

namespace fusee::fixtures {

/// Soft springs: F_SE = 0.05 + 0.02 x, F_PE = 0.05 + 0.01 x + 0.0002 x^2 [Nm], so tau = 0.1 + 0.03 x + 0.0002 x^2 over `turns` of capstan.
/// A linear law on a linear spring has a constant arm sqrt(P/k): 10 mm for K_PE, about 14 mm for K_SE; what is not linear makes them rise.
/// The cables leave parallel, to holes 10 m away, unless the guide of K_PE says otherwise. Their ends are held elsewhere: an axial hole
/// would break into the turns above.
inline std::string soft_springs(double turns, const std::string& guide) {
    const double x = 2.0 * core::kPi * turns, end = 0.1 + 0.03 * x + 0.0002 * x * x;
    return R"(name = "soft"
[rig]
capstan_radius_mm = 8.0
joint_radius_mm = 8.0
gear_friction = 0.1
least_torque_Nm = 0.12
peak_torque_Nm = 0.2
overdrive_torque_Nm = 0.25
[law]
kind = "polynomial"
series_Nm = [0.05, 0.02]
parallel_Nm = [0.05, 0.01, 0.0002]
start_torque_Nm = 0.1
end_torque_Nm = )" +
           std::to_string(end) + R"(
[cable]
diameter_mm = 0.8
[process]
kind = "fdm"
[tolerances]
chordal_error_mm = 0.005
[k_se.spring]
rate_Nm_per_rad = 0.0613
preload_rad = 1.43
[k_se.guide]
distance_mm = 10000.0
[k_se.features]
anchor_hole_mm = 0.0
[k_se.path]
kind = "helix"
pitch_mm = 4.0
[k_pe.spring]
rate_N_per_m = 100.0
preload_mm = 50.0
[k_pe.features]
anchor_hole_mm = 0.0
[k_pe.path]
kind = "helix"
)" + guide +
           (guide.find("[k_pe.guide]") == std::string::npos ? "[k_pe.guide]\ndistance_mm = 10000.0\n" : "");
}

}  // namespace fusee::fixtures
