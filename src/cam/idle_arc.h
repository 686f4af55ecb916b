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

/// The arc that closes a contour where no cable runs. Over the remaining normals its radius of curvature is piecewise linear in psi,
/// continues that of the working arc at both ends (C2) and never falls below a least radius. Otherwise it is as small and even as possible:
/// least integral of rho^2 + evenness rho'^2, with the evenness raised until the arc keeps its distance from the axis; if the axis is
/// outside all of them, (rho - R)^2 with a radius R that is raised instead. h follows from h'' + h = rho in closed form, so the curve is
/// exact and convex (docs/theory/cams.md, eq. 9).
class IdleArc {
public:
    struct Least {
        double rho = 0.0;  ///< radius of curvature [m]: a smaller one is refused
        double h = 0.0;    ///< distance of the tangents from the axis [m]: kept if possible, otherwise as large as possible
    };
    /// @param begin state at the working arc's end, at arc angle 0
    /// @param end state at the working arc's start, at arc angle `width`
    /// Refusal: "cam.idle_arc" with the largest possible radius.
    [[nodiscard]] static core::Outcome<IdleArc> close(const SupportState& begin, const SupportState& end, double width, const Least& least);

    /// An open arc: it continues from `begin`, and its radius of curvature changes to `final_rho` within a millimetre or, if longer, as
    /// evenly as over the angle `ease`. From `width` on the radius is constant.
    [[nodiscard]] static IdleArc run_out(const SupportState& begin, double width, double final_rho, double ease = 0.0);

    struct Knot {
        double x;            ///< arc angle [rad]
        SupportState state;  ///< there; between two knots rho is linear
    };
    [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }

    /// @pre 0 <= x <= width
    [[nodiscard]] SupportState at(double x) const;
    /// Length of the curve from its start to x: the integral of rho [m].
    [[nodiscard]] double length(double x) const;

private:
    [[nodiscard]] double least_h() const;

    std::vector<Knot> knots_;
};

}  // namespace fusee::cam
