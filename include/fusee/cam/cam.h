#pragma once
#include <functional>
#include <string>
#include <vector>

#include "fusee/cam/arm.h"
#include "fusee/core/finding.h"
#include "fusee/core/units.h"

/// A cam in the plane and in space: its guide or follower, its path, its contacts.
namespace fusee::cam {

enum class GuideKind { kParallel, kPoint, kIdler };

/// The cable's direction or guide beyond the cam, in the world frame W (cam axis = +z through the origin).
struct Guide {
    GuideKind kind = GuideKind::kParallel;
    double direction =
        1.5707963267948966;  ///< kParallel: world direction from the cam along the cable [rad]; else direction of the guide's centre
    double distance = 0.0;   ///< kPoint, kIdler: axis to the guide's centre [m]; kParallel: to the hole that the cable goes to, 0 = not
                             ///< stated; the contour does not depend on it
    double radius = 0.0;     ///< kIdler: pitch radius [m]
    int sense = 1;           ///< kIdler: side on which the cable passes the idler's centre: +1 or -1 (see PART.json)
    double z = 0.0;          ///< height of the guide in the part's frame [m], used by a path aimed at the guide
};

/// The follower of a cam.
enum class Family {
    kCable,   ///< a cable in its groove
    kRoller,  ///< the roller of a follower that compresses the spring; K_PE only
};
[[nodiscard]] const char* to_string(Family family);  ///< "cable", "roller"

/// What guides the roller.
enum class FollowerKind {
    kSlide,  ///< a line beside the cam's axis, along which it compresses the spring
    kArm,    ///< an arm on a pivot, which turns and compresses the spring between a pin on it and one on the frame
};

/// The arm of a roller (docs/theory/roller.md, eq. 6 to 8). At the law's lowest load the spring is at a right angle to its lever.
struct FollowerArm {
    double length = 40e-3;  ///< pivot to roller centre [m]
    double pivot = 60e-3;   ///< the cam's axis to the pivot, in the roller's direction [m]
    int side = 1;           ///< of the line from the axis to the pivot on which the roller is: +1 counter-clockwise of it, or -1
    double lever = 40e-3;   ///< pivot to the spring's pin on the arm [m]
    double spring = 60e-3;  ///< from that pin to the one on the frame at the law's lowest load [m]
};

/// A roller on the cam's rim, with what guides it (docs/theory/roller.md, eq. 1 to 4 and 6 to 8).
struct Roller {
    FollowerKind follower = FollowerKind::kSlide;
    FollowerArm arm = {};                   ///< kArm
    double radius = 6e-3;                   ///< R_r [m]
    double base_radius = 20e-3;             ///< R_b: axis to roller centre at the law's lowest load, less R_r [m]
    double offset = 0.0;                    ///< kSlide: e, distance of the line from the axis; e > 0 reduces the pressure angle [m]
    double direction = 1.5707963267948966;  ///< in the world [rad]; kSlide: along the line, away from the axis, as the spring is
                                            ///< compressed; kArm: from the axis to the pivot
    double width = 5e-3;                    ///< of the roller's cylinder [m]
    double contact_modulus = 0.0;           ///< E*: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2 [Pa]; 0 = pressure not checked
    double max_pressure = 0.0;              ///< allowed contact pressure of cam and roller, Hertz [Pa]; 0 = not checked
};

/// s_0: the roller's centre along a slide's line at the law's lowest load, from the foot of the axis' perpendicular [m].
[[nodiscard]] double follower_start(const Roller& roller);
/// A: at the pivot, from the axis to an arm's roller at the law's lowest load [rad]; NaN: the arm does not reach the rim there.
[[nodiscard]] double arm_start(const Roller& roller);
/// The same follower on a wider base radius [m]: an arm keeps its length and, at the law's lowest load, its angle to the rim's radius.
[[nodiscard]] Roller with_base(Roller roller, double base_radius);
/// The change of `with_base`: "k_pe.roller.base_radius_mm", with "k_pe.roller.pivot_mm" of an arm. @param base_mm a number as text
[[nodiscard]] core::Suggestion base_change(const Roller& roller, const std::string& base_mm);

/// The cable's centreline on the cam at one direction psi of its normal, in the body frame S (world frame at cam angle 0):
/// n = (cos psi, sin psi), t = (-sin psi, cos psi), point = h n + h' t, height z.
struct PathPoint {
    double psi = 0.0;    ///< [rad], not wrapped: a helix continues beyond 2 pi
    double h = 0.0;      ///< support function [m]
    double slope = 0.0;  ///< h' = dh/dpsi [m/rad]
    double rho = 0.0;    ///< h + h'' = radius of curvature in the plane [m]
    double z = 0.0;      ///< [m]
    [[nodiscard]] double x() const;
    [[nodiscard]] double y() const;
};

/// One working position: the needed arm, and the cable's contact with the cam (path).
struct Contact {
    ArmPoint arm;
    PathPoint path;
    double span = 0.0;   ///< free cable from the contact to the guide in the plane [m]; 0 for a parallel exit
    double fleet = 0.0;  ///< angle between free cable and the contact's plane [rad]
};

enum class PathKind { kPlanar, kHelix };
enum class Lead { kConstantPitch, kAimedAtGuide };
/// Hand of a helix: right like a common screw, whose thread rises counter-clockwise.
enum class Hand { kRight, kLeft };

struct PathOptions {
    PathKind kind = PathKind::kPlanar;
    Lead lead = Lead::kConstantPitch;
    double pitch = 0.0;                       ///< rise per turn [m]; helix only
    Hand hand = Hand::kRight;                 ///< constant pitch only: an aimed groove leads to its guide
    double margin = 0.35;                     ///< angle of the groove beyond both ends of a helix's working arc, and to the anchor [rad]
    double min_idle_curvature_radius = 2e-3;  ///< rho on the idle arc [m]
};

struct CamOptions {
    Family family = Family::kCable;
    Roller roller;  ///< of a roller cam, which has no guide and whose path is planar
    Guide guide;
    PathOptions path;
    int torque_sign = 1;           ///< sign of the tension's torque about +z
    double cable_diameter = 1e-3;  ///< d [m]; 0 for a roller, so that the path is the rim itself
    int target_rows = 400;         ///< working positions kept in `Cam::working`, evenly spaced in cam angle; 200 to 10000
};

// Of a roller cam:
/// Travel of the spring over that of the roller's centre at this place: 1 on a slide.
[[nodiscard]] double spring_ratio(const ArmPoint& arm, const CamOptions& options);
/// phi, between the contact's normal and the path of the roller's centre: on a slide tan phi = (r - e)/(s_0 + y) [rad].
[[nodiscard]] double pressure_angle(const ArmPoint& arm, const CamOptions& options);
/// Radius of curvature of the roller centre's curve on the cam [m]; below 0: the curve is concave there, and no convex rim exists.
[[nodiscard]] double pitch_radius(const ArmPoint& arm, const CamOptions& options);
/// N, between rim and roller: that of the spring along the path of the roller's centre, over cos phi [N].
[[nodiscard]] double rim_force(const ArmPoint& arm, const CamOptions& options);
/// Torque about the cam's axis that friction takes in the follower's guide [Nm], a plain bearing of this coefficient: of a slide under the
/// side force, of an arm's pivot under N and F together, on a pin of half the roller's diameter.
[[nodiscard]] double guide_friction(const ArmPoint& arm, const CamOptions& options, double coefficient);
/// Largest pressure between cam and roller, two cylinders along one line (Hertz): sqrt(N E*/(pi width) (1/R_r + 1/rho)) [Pa].
[[nodiscard]] double contact_pressure(const ArmPoint& arm, const CamOptions& options);

struct ContourPiece;

/// A finished cam in the plane and in space; immutable. The input of solids, checks, exports and reports.
struct Cam {
    PartKind kind = PartKind::kSeries;
    CamOptions options;
    int rotation_sign = 1;                  ///< at cam angle a the body is turned by rotation_sign * a about +z
    std::vector<Contact> working;           ///< by rising cam angle
    core::Range working_psi;                ///< psi of the working arc, low < high
    core::Range groove_psi;                 ///< range of the cut groove: planar = one whole turn, helix = working arc and margins
    double anchor_psi = 0.0;                ///< place of the cable's anchor, just outside the working arc, at the wound end
    std::function<PathPoint(double)> path;  ///< at any psi of groove_psi, for a helix also beyond it; C2, thread-safe
    std::function<std::vector<ContourPiece>()> pieces;  ///< the same path for `certify` (certificate.h); empty: not synthesized
    [[nodiscard]] bool closed() const { return options.path.kind == PathKind::kPlanar; }
    [[nodiscard]] bool has_roller() const { return options.family == Family::kRoller; }
};

/// Turns an arm function into a cam: contact and contour from the guide's geometry, height, margins and (planar) the closed idle arc.
/// Refusals (findings): "cam.arm" (an arm under 0.1 mm, or a contact more than 1 m from the axis), "cam.guide" (arm larger than the guide's
/// distance), "cam.convexity" (rho <= 0 on the working arc), "cam.wrap" (more than one turn and planar, or more than 20 turns),
/// "cam.idle_arc" (the idle arc does not close with the least radius).
/// @throws InvalidInput naming the option
[[nodiscard]] core::Outcome<Cam> synthesize_cam(const ArmFunction& arm, const CamOptions& options);

}  // namespace fusee::cam
