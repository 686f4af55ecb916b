#pragma once
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/design_report.h"

namespace fusee::pipeline {

/// The angles of a single spring's law [rad].
[[nodiscard]] core::Range law_angles(const ResolvedDesign& design);

/// Sets `of_both` of the report: the law, and the difference of both cables' torques by the arms of their first files. With files it adds
/// "readback.torque": of every file and reader that both have, the largest error over the largest torque. @pre design.ways is not empty,
/// and the report has both parts
void judge_both_ways(DesignReport& report, const ResolvedDesign& design);

}  // namespace fusee::pipeline
