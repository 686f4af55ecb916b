#pragma once
#include <array>

#include "fusee/joint_model/built_rig.h"
#include "fusee/joint_model/hysteresis.h"
#include "fusee/joint_model/rig_lanes.h"

namespace fusee::joint_model {

// Steps of the reference rig.
inline constexpr double kSlowStep = 2e-3;      ///< of a slow experiment [s]: error at most 2 mrad
inline constexpr double kDeadBandStep = 3e-3;  ///< of a dead-band test, of which only the end is read [s]: error at most 2 %
inline constexpr double kLogStep = 5e-4;       ///< of a log [s]: error 2 mrad after 8 s of fast motion

/// The same step on a rig: as much longer as its time is (gap_case::Reference), at most kStepRange times as long or short beside its
/// phases, so that neither light motors make a diagnosis endless nor heavy ones end a phase in a few steps.
[[nodiscard]] double step_on(const gap_case::Reference& reference, const gap_case::Protocol& protocol, double step);
inline constexpr double kStepRange = 4.0;

/// Positions and speeds of the three bodies, and what springs, cables and gears remember. V: of one rig, or of four in lanes.
template <class V>
struct MotionState {
    std::array<V, 3> place{}, speed{};          ///< of the agonist's capstan, the antagonist's, the joint [rad], [rad/s]
    std::array<HysteresisOf<V>, 4> hysteresis;  ///< SE, PE of the agonist, SE, PE of the antagonist
    std::array<V, 4> relaxed{};                 ///< torque of each, as its relaxation follows it [Nm]
    std::array<V, 2> slipped{};                 ///< cable that slipped on each capstan [rad]
    std::array<V, 2> jumped{};                  ///< 1: the cable has left its groove
    std::array<V, 2> encoder{};                 ///< of each motor, as its gear's backlash takes it along; 0 without backlash [rad]
    V turned{}, turning{};                      ///< of the link on the pulley, where it has play [rad]; speed of the link [rad/s]
};

/// A built rig in motion, or four of one case at once (MotionOf<Lanes>, each with the bits that it has alone):
/// J v' = torque - loads - friction, set-valued friction (a body below its limit does not move).
/// Symplectic Euler with the friction's impulse solved body by body (Moreau 1988): no numerical damping, no creep.
template <class V>
class MotionOf {
public:
    /// Begins at rest at angle 0 without torque, at a time of the session [s]. The rigs must outlive it.
    MotionOf(const RigsOf<V>& rigs, double longest_step, V session);
    explicit MotionOf(const BuiltRig& rig, double longest_step, double session = 0.0) requires(kWidth<V> == 1)
        : MotionOf(RigsOf<V>{&rig}, longest_step, session) {}

    struct Torques {
        V agonist{}, antagonist{}, joint{};  ///< commanded [Nm]
    };
    /// Ramps the torques linearly to `torques` within `seconds`.
    void lead_to(const Torques& torques, V seconds);
    /// The same along 3 s^2 - 2 s^3, in linear pieces.
    void lead_smoothly_to(const Torques& torques, V seconds);
    void hold(V seconds) { lead_to(torques_, seconds); }

    [[nodiscard]] V theta(gap_case::Side side) const { return state_.place[static_cast<std::size_t>(side)]; }  ///< [rad]
    /// Angle of a capstan as the encoder of its motor has it, behind the backlash of the gear [rad].
    [[nodiscard]] V encoder(gap_case::Side side) const;
    [[nodiscard]] V q() const { return state_.place[2] + state_.turned; }  ///< of the link [rad]
    [[nodiscard]] V joint_torque() const { return torques_.joint; }        ///< commanded [Nm]
    [[nodiscard]] V session() const { return session_; }                   ///< [s]
    [[nodiscard]] const RigsOf<V>& rigs() const { return rig_.rigs; }
    V hand_damping{};  ///< at the joint, of a hand that follows it [Nms/rad]

private:
    RigLanes<V> rig_;
    double longest_step_;
    V session_;
    Torques torques_;
    MotionState<V> state_;
};
using Motion = MotionOf<double>;

}  // namespace fusee::joint_model
