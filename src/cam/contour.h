#pragma once
#include <vector>

#include "fusee/cam/certificate.h"
#include "path.h"

/// A cam's path in pieces with computable bounds, by the same formulas as its points.
namespace fusee::cam {

/// The working arc; empty if the law has no bounds.
[[nodiscard]] std::vector<ContourPiece> working_pieces(const ArmFunction& arm, const CamOptions& options, const Height& height);

/// A planar contour's idle arc, from the working arc's high end on.
[[nodiscard]] std::vector<ContourPiece> idle_pieces(const IdleArc& arc, double begin_psi);

/// A helix beyond one end of its working arc.
[[nodiscard]] std::vector<ContourPiece> run_out_pieces(const RunOut& run_out);

}  // namespace fusee::cam
