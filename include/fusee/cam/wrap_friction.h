#pragma once
#include <vector>

#include "fusee/cam/cam.h"

/// Friction between a cam and an elastic cable whose tension changes (docs/theory/wrap_friction.md).
namespace fusee::cam {

/// An elastic cable on a rigid convex body, fixed at its inner end and pulled at its outer end. A piece slips where the tension changes
/// along the wrap faster than friction allows (Euler, Eytelwein: dT/dturn = mu T), and moves by its elongation. Slip starts at the outer
/// end.
class WrappedCable {
public:
    /// @param friction mu, >= 0 @param stiffness E A of the cable [N], > 0 @throws InvalidInput naming cable.friction or cable.stiffness_N
    WrappedCable(double friction, double stiffness);

    /// Winds a piece on at the outer end. It keeps the tension at which it is laid. @param turn of its normals [rad] @param length [m]
    void lay(double turn, double length, double tension);
    /// Unwinds the outermost piece. @pre at least one piece is laid
    void unlay() { pieces_.pop_back(); }
    /// Pulls the outer end with another tension [N].
    void pull(double tension);

    [[nodiscard]] double elongation() const;                         ///< of the wound cable [m]
    [[nodiscard]] double dissipated() const { return dissipated_; }  ///< by slip, since the start [J]

private:
    struct Piece {
        double turn, length, tension;
    };
    double friction_, stiffness_;
    std::vector<Piece> pieces_;  // from the inner end outwards
    double dissipated_ = 0.0;
};

struct WrapFriction {
    double friction = 0.0;   ///< mu of the cable on the cam
    double stiffness = 0.0;  ///< E A of the cable [N]
};

/// One working position of a cam whose tension has cycled over the working range until the cycle repeats.
struct WrapRow {
    double angle = 0.0;                 ///< cam angle [rad]
    double tau = 0.0;                   ///< load [Nm]
    double tension = 0.0;               ///< of the law [N]
    double elongation_loading = 0.0;    ///< of the wound cable, load rising [m]
    double elongation_unloading = 0.0;  ///< load falling [m]
    /// Additional deflection of the spring, at the capstan and the same load, compared to a rigid cable [rad].
    double deflection_loading = 0.0, deflection_unloading = 0.0;
    [[nodiscard]] double width() const {
        return deflection_unloading - deflection_loading;
    }  ///< of the loop [rad]; the cable is longer while the load falls
};

struct WrapLoop {
    std::vector<WrapRow> rows;  ///< one for each working position
    double dissipated = 0.0;    ///< in one cycle [J]
};

/// Cycles the cable of a cam on its wound arc, from the anchor to the contact, through the working range and back until the cycle repeats.
/// To first order in the elongation e: tensions are those of the law. K_SE deflects by e/r_c. The compression spring of K_PE, of rate k, is
/// relieved by k e, so that K_PE deflects by k e r/P at its stiffness P = F r' + k r^2.
/// @param rate of the base spring @param capstan_radius r_c [m]
/// @pre a cam for a cable, with working positions @throws as WrappedCable
[[nodiscard]] WrapLoop wrap_loop(const Cam& cam, double rate, double capstan_radius, const WrapFriction& friction);

}  // namespace fusee::cam
