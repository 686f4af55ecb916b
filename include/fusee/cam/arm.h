#pragma once
#include <optional>
#include <span>

#include "fusee/math/chebyshev.h"
#include "fusee/spring/base_spring.h"
#include "fusee/spring/law.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {
struct LawJet;
}

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

enum class PartKind {
    kSeries,    ///< K_SE: a spool on a torsion spring, which pays out cable; turns with the tension
    kParallel,  ///< K_PE: a cam on the capstan, which draws in the cable of a compression spring; turns against the tension
};
[[nodiscard]] const char* to_string(PartKind kind);  ///< "k_se", "k_pe"

/// Cable elongation since the law's lowest load, and its share of the capstan's travel.
struct CableElongation {
    double length = 0.0;  ///< [m]
    double turn = 0.0;    ///< capstan angle that it takes [rad]
    double travel = 0.0;  ///< total capstan angle: theta [rad]
    [[nodiscard]] double share() const { return travel > 0.0 ? turn / travel : 0.0; }
};

/// The arm that the law needs at one load.
struct ArmPoint {
    double tau = 0.0;                 ///< capstan load [Nm]: names the point
    double angle = 0.0;               ///< rotation of the cam from the law's lowest load [rad], >= 0
    double arm = 0.0;                 ///< r, torque over tension [m]; pivot to cable centreline at a fleet angle of 0
    double slope = 0.0;               ///< r' = dr/dangle [m/rad]
    double second_derivative = 0.0;   ///< r'' [m/rad^2]
    double tension = 0.0;             ///< cable tension [N]
    double state = 0.0;               ///< phi + phi0 [rad] or y + y0 [m] of the base spring
    double travel = 0.0;              ///< change of state since the law's lowest load: phi [rad] or y [m]
    CableElongation elongation = {};  ///< 0 unless `Allowance` states a compliance
};

/// Deviations of the rig, for which the cam is compensated (docs/guides/close-the-loop.md). All 0: a nominal rig.
struct Allowance {
    double radius = 0.0;             ///< added to every arm [m], of either sign: a thicker cable, overcut, less shrinkage
    double series_compliance = 0.0;  ///< K_SE only: compliance behind the spool besides `cable_compliance`, >= 0 [rad/Nm] at the capstan
    double cable_axis = 0.0;         ///< distance of the cable's neutral axis beyond d/2, from coupons [m]; added like `radius`
    double cable_compliance = 0.0;   ///< L/(E A): cable elongation per tension, >= 0 [m/N] (docs/theory/cams.md, eq. 18)
    double contour = 0.0;            ///< excess of this part's contour along its normal, from its inspection [m]; added like `radius`
    [[nodiscard]] double on_arms() const { return radius + cable_axis + contour; }
    /// Total compliance behind K_SE's spool [rad/Nm] at the capstan.
    [[nodiscard]] double behind_spool(double capstan_radius) const {
        return series_compliance + cable_compliance / (capstan_radius * capstan_radius);
    }
};

/// The duality of spool and cam: energy gives the arm, without an ODE (docs/theory/cams.md, table 1).
class ArmFunction {
public:
    /// @param capstan_radius r_c [m], turns the series torque into cable tension
    /// @param allowance with these arms, r - dr, rig and cam together carry the law. Behind a compliance c the spool has the cable's
    /// travel less c (F_SE - F_SE at the law's lowest load), so that its own stiffness is S/(1 - c S). K_PE's cam pulls its spring through
    /// the cable, by `spring::in_series_with_cable`
    /// @throws InvalidInput if the base spring is of the other kind, its rate or the radius is not above 0, its preload is below 0, or the
    /// compliance behind the spool is not below 1/S over the law, so that no spool can compensate for it
    ArmFunction(PartKind kind, spring::SpringLawPtr law, spring::BaseSpring base, double capstan_radius, const Allowance& allowance = {});

    [[nodiscard]] ArmPoint at_load(double tau) const;
    /// The same formulas over a box of the law (spring/enclosure.h, cam/enclosure.h).
    [[nodiscard]] ArmJet over(const spring::LawJet& law) const;
    /// The same law on another base spring. @throws InvalidInput as the constructor
    [[nodiscard]] ArmFunction on(const spring::BaseSpring& base) const;
    /// The arms in the plane for a cable with these fleet angles (docs/theory/cams.md, eq. 8a).
    [[nodiscard]] ArmFunction corrected_for_fleet_angle(const FleetAngleCorrection& correction) const;
    [[nodiscard]] PartKind kind() const { return kind_; }
    [[nodiscard]] const spring::SpringLaw& law() const { return *law_; }
    [[nodiscard]] const spring::BaseSpring& base() const { return base_; }

private:
    template <class Point>
    [[nodiscard]] Point behind_cable(Point p) const;
    template <class Arm, class Point>
    [[nodiscard]] Arm arm_of(const Point& law) const;
    [[nodiscard]] CableElongation elongation(const spring::LawPoint& law, double tension) const;

    PartKind kind_;
    spring::SpringLawPtr law_;
    spring::BaseSpring base_;
    double capstan_radius_;
    Allowance allowance_;
    spring::BaseSpring pulled_;         ///< the load of K_PE's cam: the base spring and its cable
    double behind_spool_ = 0.0;         ///< K_SE: compliance [rad/Nm] at the capstan
    double least_series_torque_ = 0.0;  ///< K_SE: F_SE at the law's lowest load [Nm]
    std::optional<FleetAngleCorrection> fleet_correction_;
};

/// A cam's arm at one cam angle, as found on a part.
struct FoundArm {
    double angle = 0.0;  ///< cam rotation from the law's lowest load [rad]
    double arm = 0.0;    ///< r, torque over tension [m]; > 0
};

/// The spring at the capstan that follows from a cam's arms and its base spring: the inverse of `ArmFunction` (docs/theory/read_back.md,
/// eq. 1 and 2). Between the rows the arm is their quintic interpolant; torque over the capstan's travel from 0, the law's lowest load, to
/// the last row. Allowance: additions of the rig to each arm, and cable elongation: besides K_SE's travel, behind K_PE's cam.
/// @throws InvalidInput naming "arms[3]" (not above 0) or "angle[3]" (not finite, not ascending), or fewer than 4 rows
[[nodiscard]] spring::PotentialPtr spring_of_arms(PartKind kind, std::span<const FoundArm> arms, const spring::BaseSpring& base,
                                                  double capstan_radius, const Allowance& allowance = {});

}  // namespace fusee::cam
