#pragma once
#include <mutex>
#include <unordered_map>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/math/interval.h"
#include "idle_arc.h"

namespace fusee::cam {

/// The contour's working arc, addressed by psi: exact between its samples (the load at psi is solved for, not interpolated). A point that
/// was asked for is remembered, because sweep, outlines and splines ask for the same ones. Any number of threads may ask.
class WorkingArc {
public:
    /// @param contacts at rising loads; psi strictly monotone
    WorkingArc(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& contacts);

    [[nodiscard]] core::Range psi() const { return {entries_.front().psi, entries_.back().psi}; }
    /// Height not yet included. @pre psi inside psi() (clamped)
    [[nodiscard]] PathPoint at(double psi) const;

private:
    struct Entry {
        double psi, tau;
    };
    [[nodiscard]] PathPoint solved(double psi) const;

    ArmFunction arm_;
    CamOptions options_;
    std::vector<Entry> entries_;  // by rising psi
    mutable std::mutex mutex_;    // of `known_`
    mutable std::unordered_map<double, PathPoint> known_;
};

/// Height of the groove over psi (docs/theory/cams.md, eq. 8): flat, rising with constant pitch from 0 at the working arc's low end, or
/// aimed so that the groove points at the guide: dz/ds = (z_guide - z)/free span along the leaving cable.
class Height {
public:
    Height(const CamOptions& options, const std::vector<Contact>& contacts);
    /// @pre inside the working arc (clamped to it)
    [[nodiscard]] double at(double psi) const;
    /// dz/dpsi where the working arc begins (false) and ends (true) [m/rad].
    [[nodiscard]] double slope_at(bool high_end) const;
    /// Bounds of dz/dpsi [m/rad] and d2z/dpsi2 [m/rad^2] over a box of psi.
    struct AxialSlope {
        math::Interval first, second;
    };
    [[nodiscard]] AxialSlope over(const math::Interval& psi) const;

private:
    struct Entry {
        double psi, z, slope;
    };
    Lead lead_;
    std::vector<Entry> entries_;  // by rising psi; empty = flat
};

/// A helix beyond one end of its working arc: convex and C2. Its radius of curvature changes to that of a circle about the axis. The height
/// continues with the same pitch (constant pitch) or the same slope along the groove (aimed). With a constant pitch the change is long
/// enough that the groove does not bend sharply in space (docs/theory/cams.md, eq. 10).
class RunOut {
public:
    /// @param end end of the working arc, height included
    /// @param direction +1 beyond the arc's high end, -1 below its low end
    /// @param axial_slope dz/dpsi there [m/rad]
    RunOut(const PathPoint& end, int direction, double width, double axial_slope, Lead lead);
    [[nodiscard]] PathPoint at(double psi) const;
    /// dz/dpsi and d2z/dpsi2 at this rho, a function of psi: with constant pitch as at the end, otherwise in proportion to rho.
    [[nodiscard]] Height::AxialSlope over(const math::Jet& rho) const;
    [[nodiscard]] const IdleArc& arc() const { return arc_; }
    [[nodiscard]] const PathPoint& end() const { return end_; }
    [[nodiscard]] int direction() const { return direction_; }

private:
    PathPoint end_;
    int direction_;
    double axial_slope_;
    Lead lead_;
    IdleArc arc_;
};

}  // namespace fusee::cam
