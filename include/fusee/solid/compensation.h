#pragma once
#include <array>

#include "fusee/solid/part.h"

/// Compensates files for the shrinkage of a process, so that the part comes out nominal. The design itself stays nominal.
namespace fusee::solid {

/// Deviations of a process, measured on coupons (docs/theory/calibration.md).
struct Compensation {
    std::array<double, 3> shrink{};  ///< along x, y, z: a length L comes out as (1 - shrink) L; below 0: it grows
    double bore_offset = 0.0;        ///< loss of a bore's diameter besides shrinkage [m]
    [[nodiscard]] bool scales() const { return shrink != std::array<double, 3>{}; }
    [[nodiscard]] bool none() const { return !scales() && bore_offset == 0.0; }
};

/// The part with bore and key wider by `offset` [m]: each of their walls moves by half of it, nothing else moves.
/// Refusal: as build_part, if there is no space for the wider bore
[[nodiscard]] core::Outcome<Part> with_wider_bore(const Part& part, double offset);

/// The mesh to write so that the part comes out as `mesh`: every coordinate divided by (1 - shrink), rounded to single precision.
[[nodiscard]] Mesh grown(const Mesh& mesh, const std::array<double, 3>& shrink);

}  // namespace fusee::solid
