#pragma once
#include <vector>

#include "fusee/core/finding.h"

namespace fusee::cam {

/// State of a planar curve at one normal direction.
struct SupportState {
    double h = 0.0;      ///< [m]
    double slope = 0.0;  ///< h' [m/rad]
    double rho = 0.0;    ///< h + h'' [m]
};

/// The arc that closes a contour where no cable runs: on the normals that are left, the radius of curvature is piecewise linear in psi,
/// meets the working arc's at both ends (C2), never falls below a least radius, and is otherwise as small and even as closing allows (least
/// integral of rho^2 + evenness rho'^2, the evenness raised until the arc keeps its distance from the axis). h follows from h'' + h = rho
/// in closed form, so the curve is exact and convex (docs/theory/cams.md, eq. 9).
class IdleArc {
public:
    struct Least {
        double rho = 0.0;  ///< radius of curvature [m]: kept or refused
        double h = 0.0;    ///< distance of the tangents from the axis [m]: kept if possible, else as large as possible
    };
    /// @param begin state where the working arc ends, at arc angle 0
    /// @param end   state where it starts again, at arc angle `width`
    /// Refusal: "cam.idle_arc" with the radius that can be had at most.
    [[nodiscard]] static core::Outcome<IdleArc> close(const SupportState& begin, const SupportState& end, double width, const Least& least);

    /// An arc that closes nothing: goes on from `begin` and lets the radius of curvature run out to `final_rho`, within a millimetre or, if
    /// that is longer, as evenly as over the angle `ease`; from `width` on the radius stays as it is there.
    [[nodiscard]] static IdleArc run_out(const SupportState& begin, double width, double final_rho, double ease = 0.0);

    struct Knot {
        double x;            ///< arc angle [rad]
        SupportState state;  ///< there; between two knots rho runs linearly
    };
    [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }

    /// @pre 0 <= x <= width
    [[nodiscard]] SupportState at(double x) const;
    /// Length of the curve from the beginning to x: the integral of rho [m].
    [[nodiscard]] double length(double x) const;

private:
    [[nodiscard]] double least_h() const;

    std::vector<Knot> knots_;
};

}  // namespace fusee::cam
