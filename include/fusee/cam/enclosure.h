#pragma once
#include "fusee/cam/cam.h"
#include "fusee/math/interval.h"
#include "fusee/spring/enclosure.h"

/// Arms and contacts over boxes of a law's parameter, by the same formulas as their points: what `certify` proves with.
namespace fusee::cam {

/// Every figure of an `ArmPoint` over a box, with its derivative by the box's parameter.
struct ArmJet {
    math::Jet tau, angle, arm, slope, second_derivative, tension, state, travel;
};

/// Every figure of a `Contact` in the plane over a box, with its derivative by the box's parameter.
struct ContactJet {
    struct Path {
        math::Jet psi, h, slope, rho;
    };
    ArmJet arm;
    Path path;
    math::Jet span;
};

/// `touch` over a box. Where the box leaves a tangent in doubt, rho may be anything.
[[nodiscard]] ContactJet touch(PartKind kind, const ArmJet& arm, const CamOptions& options);

}  // namespace fusee::cam
