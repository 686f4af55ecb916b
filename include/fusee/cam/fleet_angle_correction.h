#pragma once
#include <span>

#include "fusee/math/chebyshev.h"

namespace fusee::cam {

struct ArmJet;
struct ArmPoint;

/// At a fleet angle the torque on the cam is cos(fleet) times tension times arm (docs/theory/cams.md, eq. 8a). This class holds cos(fleet)
/// over the cam's angle as a Chebyshev series, which is twice differentiable and has bounds over boxes.
class FleetAngleCorrection {
public:
    using Shares = math::ChebyshevSeries::Values;
    /// Cam angles at which a series needs its shares, 0 to `last` [rad].
    [[nodiscard]] static Shares places(double last) { return math::ChebyshevSeries::points({0.0, last}); }
    /// @param shares at `places(last)`, in (0, 1]
    FleetAngleCorrection(double last, const Shares& shares);

    /// Replaces arm, slope and second derivative of the torque by those in the plane.
    void project_to_plane(ArmPoint& arm) const { project(arm); }
    void project_to_plane(ArmJet& arm) const { project(arm); }

private:
    template <class Arm>
    void project(Arm& arm) const;

    math::ChebyshevSeries share_, first_, second_;
};

}  // namespace fusee::cam
