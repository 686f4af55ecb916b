#pragma once
#include <array>

#include "fusee/solid/part.h"

/// Files for a process that shrinks what it makes, so that the part comes out as it was designed. The design itself stays nominal.
namespace fusee::solid {

/// What a process does to a part, as coupons measured it (docs/theory/calibration.md).
struct Compensation {
    std::array<double, 3> shrink{};  ///< along x, y, z: a length L comes out as (1 - shrink) L; below 0: it grows
    double bore_offset = 0.0;        ///< what a bore, shrinkage aside, comes out smaller by, in diameter [m]
    [[nodiscard]] bool scales() const { return shrink != std::array<double, 3>{}; }
    [[nodiscard]] bool none() const { return !scales() && bore_offset == 0.0; }
};

/// The part with its bore and key wider by `offset` [m], every wall of theirs moved by half of it; nothing else moves.
/// Refusal: as build_part, when the wider bore has no room
[[nodiscard]] core::Outcome<Part> with_wider_bore(const Part& part, double offset);

/// What has to be in the file so that `mesh` comes out: every coordinate over (1 - shrink), rounded to single precision.
[[nodiscard]] Mesh grown(const Mesh& mesh, const std::array<double, 3>& shrink);

}  // namespace fusee::solid
