#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/math/interval.h"

/// Proof of convexity and of the least radius of curvature by interval arithmetic over the whole contour (docs/theory/cams.md).
namespace fusee::cam {

/// A contour over a box of a parameter, with derivatives by that parameter.
struct ContourJet {
    math::Jet psi;                                             ///< direction of the normal [rad]
    math::Jet rho;                                             ///< radius of curvature in the plane, cable's centreline [m]
    math::Jet angle;                                           ///< cam angle at which the cable leaves there [rad]; working pieces only
    math::Interval axial_slope = 0.0, axial_slope_rate = 0.0;  ///< dz/dpsi [m/rad], d2z/dpsi2 [m/rad^2]
};

/// A piece of a contour that is one smooth formula of one parameter.
struct ContourPiece {
    core::Range parameter;
    bool working = true;                                    ///< true: a cable leaves here; false: an idle arc or a run-out
    std::function<ContourJet(const math::Interval&)> over;  ///< @pre the box lies in `parameter`; thread-safe
};

enum class Proof {
    kProven,     ///< holds everywhere
    kRefuted,    ///< fails at a known place
    kNotProven,  ///< undecided after the allowed number of boxes, or the law has no bounds
};
[[nodiscard]] const char* to_string(Proof proof);  ///< "proven", "refuted", "not proven"

/// Bounds of the least radius of curvature [m].
struct LeastRadius {
    double proven = 0.0;  ///< no radius is smaller; -infinity: nothing is proven
    double found = 0.0;   ///< a radius in `psi` is at most this
    core::Range psi;      ///< the box with the lowest bound [rad]
};

struct Certificate {
    Proof convex = Proof::kNotProven;                ///< rho > 0 on all of the contour
    Proof ordered = Proof::kNotProven;               ///< psi runs strictly one way as the cam turns: the cable unrolls in order
    LeastRadius working;                             ///< rho, cable's centreline in the plane, on the working arc
    std::optional<LeastRadius> idle;                 ///< the same on the idle arc, or on a helix' run-outs
    std::optional<LeastRadius> floor;                ///< helix: radius in space of the groove's floor, on the working arc
    std::optional<LeastRadius> idle_floor;           ///< the same on its run-outs
    double seam = 0.0;                               ///< jump of h and h' where a planar contour closes [m]
    int boxes = 0;                                   ///< evaluated
    std::string open;                                ///< the unproven claims with their boxes; empty if all are proven
    [[nodiscard]] const LeastRadius& least() const;  ///< of working and idle: the one with the lower bound
};

struct CertifyOptions {
    double gap = 1e-4;         ///< relative, between `proven` and `found`, at which a search ends; > 0; in space ten times that
    int most_boxes = 100000;   ///< of each search
    double floor_depth = 0.0;  ///< of a hand-made helix: the floor's curve is h less this [m]
};

/// Gives nothing if convexity and order are proven, otherwise the finding "cam.certificate": a warning, or an error if refuted.
[[nodiscard]] std::optional<core::Finding> doubt(const Certificate& certificate, PartKind kind);

/// The assumptions of a certificate, printed with it.
[[nodiscard]] const std::vector<std::string>& certificate_assumptions();

/// Certifies the cam's own formulas. "Not proven" for a cam that was not synthesized or whose law has no bounds. Deterministic; reentrant.
[[nodiscard]] Certificate certify(const Cam& cam, const CertifyOptions& options = {});

/// The jump of h and h' where a planar contour closes [m]; 0 for a helix.
[[nodiscard]] double seam(const Cam& cam);

/// The same for a contour given in pieces.
/// @param helix also the floor's radius in space
/// @throws InvalidInput unless gap > 0 and most_boxes >= 1
[[nodiscard]] Certificate certify(const std::vector<ContourPiece>& contour, bool helix, const CertifyOptions& options = {});

}  // namespace fusee::cam
