#pragma once
#include <vector>

#include "fusee/cam/cam.h"

/// What friction between cable and cam does to an elastic cable as its tension changes (docs/theory/wrap_friction.md).
namespace fusee::cam {

/// An elastic cable on a rigid convex body, its inner end fixed, its outer end pulled. A piece slips where the tension changes along the
/// wrap faster than friction holds (Euler, Eytelwein: dT/dturn = mu T), and creeps by what it stretches. Slip starts at the outer end.
class WrappedCable {
public:
    /// @param friction mu, >= 0 @param stiffness E A of the cable [N], > 0 @throws InvalidInput naming cable.friction or cable.stiffness_N
    WrappedCable(double friction, double stiffness);

    /// Winds a piece on at the outer end: it lies at the tension that it is laid with. @param turn of its normals [rad] @param length [m]
    void lay(double turn, double length, double tension);
    /// Unwinds the outermost piece. @pre some piece is laid
    void unlay() { pieces_.pop_back(); }
    /// Pulls the outer end with another tension [N].
    void pull(double tension);

    [[nodiscard]] double stretch() const;                             ///< of what is wound on [m]
    [[nodiscard]] double dissipated() const { return dissipated_; }   ///< by slip, since the beginning [J]
    [[nodiscard]] double slipping_turn() const { return slipping_; }  ///< from the outer end, in the last pull [rad]

private:
    struct Piece {
        double turn, length, tension;
    };
    double friction_, stiffness_;
    std::vector<Piece> pieces_;  // from the inner end outwards
    double dissipated_ = 0.0, slipping_ = 0.0;
};

struct WrapFriction {
    double friction = 0.0;   ///< mu of the cable on the cam
    double stiffness = 0.0;  ///< E A of the cable [N]
};

/// One working position of a cam whose tension has cycled over the working range until the cycle repeats.
struct WrapRow {
    double angle = 0.0;              ///< cam angle [rad]
    double tau = 0.0;                ///< load [Nm]
    double tension = 0.0;            ///< of the law [N]
    double stretch_loading = 0.0;    ///< of the wound cable, on the way up [m]
    double stretch_unloading = 0.0;  ///< on the way down [m]
    /// What the spring gives way more, at the capstan and the same load, than behind a rigid cable [rad].
    double give_loading = 0.0, give_unloading = 0.0;
    [[nodiscard]] double width() const { return give_unloading - give_loading; }  ///< of the loop [rad]; a cable is longer on the way down
};

struct WrapLoop {
    std::vector<WrapRow> rows;  ///< one for each working position
    double dissipated = 0.0;    ///< in one cycle [J]
};

/// The cable of a cam on its wound arc, from the anchor to where it leaves, through the working range and back until that repeats. To first
/// order in the stretch e: tensions are those of the law. K_SE gives way by e/r_c; K_PE, whose compression spring of rate k is relieved by
/// k e, by k e r/P at its stiffness P = F r' + k r^2.
/// @param rate of the base spring @param capstan_radius r_c [m]
/// @pre a cable's cam, with positions @throws as WrappedCable
[[nodiscard]] WrapLoop wrap_loop(const Cam& cam, double rate, double capstan_radius, const WrapFriction& friction);

}  // namespace fusee::cam
