#pragma once
#include "fusee/report/report.h"
#include "picture/plot.h"

/// The charts of `fusee render`; each needs what it shows. The pages draw theirs in the browser (web/src/pages/design).
namespace fusee::report {

[[nodiscard]] Plot law_chart(const LawReport& law);           ///< torques over the capstan's angle
[[nodiscard]] Plot stiffness_chart(const LawReport& law);     ///< of both springs over the load
[[nodiscard]] Plot transmission_chart(const LawReport& law);  ///< T = S/(S+P)
[[nodiscard]] Plot dead_band_chart(const std::vector<actuator::DeadBand>& levels);
[[nodiscard]] Plot joint_stiffness_chart(const std::vector<actuator::DeadBand>& levels);
[[nodiscard]] Plot arm_chart(const cam::Cam& cam);
[[nodiscard]] Plot height_chart(const cam::Cam& cam);  ///< of the cable on a helix

}  // namespace fusee::report
