#pragma once
#include "fusee/cam/cam.h"
#include "fusee/math/interval.h"
#include "fusee/spring/enclosure.h"

/// Arms and contacts over boxes of a law's parameter, by the same formulas as at points. `certify` uses them.
namespace fusee::cam {

/// Every value of an `ArmPoint` over a box, with its derivative by the box's parameter.
struct ArmJet {
    math::Jet tau, angle, arm, slope, second_derivative, tension, state, travel;
};

/// Every value of a `Contact` in the plane over a box, with its derivative by the box's parameter.
struct ContactJet {
    struct Path {
        math::Jet psi, h, slope, rho;
    };
    ArmJet arm;
    Path path;
    math::Jet span;
};

/// `touch` over a box. If the box leaves the tangent uncertain, rho is unbounded.
[[nodiscard]] ContactJet touch(PartKind kind, const ArmJet& arm, const CamOptions& options);

}  // namespace fusee::cam
