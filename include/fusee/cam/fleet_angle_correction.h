#pragma once
#include <span>

#include "fusee/math/chebyshev.h"

namespace fusee::cam {

struct ArmJet;
struct ArmPoint;

/// A cable that leans out of the contact's plane by the fleet angle turns its cam by cos(fleet) of tension times arm (docs/theory/cams.md,
/// eq. 8a). That share over the cam's angle, as a Chebyshev series: twice differentiable, and with bounds over boxes.
class FleetAngleCorrection {
public:
    using Shares = math::ChebyshevSeries::Values;
    /// Cam angles at which a series wants its shares, 0 to `last` [rad].
    [[nodiscard]] static Shares places(double last) { return math::ChebyshevSeries::points({0.0, last}); }
    /// @param shares at `places(last)`, in (0, 1]
    FleetAngleCorrection(double last, const Shares& shares);

    /// Puts the arm in the plane, its slope and its bend, in the place of those that the torque asks for.
    void project_to_plane(ArmPoint& arm) const { project(arm); }
    void project_to_plane(ArmJet& arm) const { project(arm); }

private:
    template <class Arm>
    void project(Arm& arm) const;

    math::ChebyshevSeries share_, first_, second_;
};

}  // namespace fusee::cam
