#pragma once
#include <vector>

#include "fusee/cam/certificate.h"
#include "fusee/cam/path.h"

/// A cam's path in stretches whose bounds can be computed, by the formulas that compute its points.
namespace fusee::cam {

/// The working arc; empty if the law cannot say its bounds.
[[nodiscard]] std::vector<ContourStretch> working_stretches(const ArmFunction& arm, const CamOptions& options, const Height& height);

/// A planar contour's idle arc, from the working arc's high end on.
[[nodiscard]] std::vector<ContourStretch> idle_stretches(const IdleArc& arc, double begin_psi);

/// A helix beyond one end of its working arc.
[[nodiscard]] std::vector<ContourStretch> run_out_stretches(const RunOut& run_out);

}  // namespace fusee::cam
