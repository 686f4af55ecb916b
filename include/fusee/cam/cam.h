#pragma once
#include <functional>
#include <string>
#include <vector>

#include "fusee/cam/arm.h"
#include "fusee/cam/guide.h"
#include "fusee/cam/roller.h"
#include "fusee/core/finding.h"
#include "fusee/core/units.h"

namespace fusee::cam {

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
