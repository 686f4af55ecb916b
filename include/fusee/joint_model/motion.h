#pragma once
#include <array>

#include "fusee/joint_model/built_rig.h"
#include "fusee/joint_model/hysteresis.h"

namespace fusee::joint_model {

// Steps of the reference rig.
inline constexpr double kSlowStep = 2e-3;      ///< of a slow experiment [s]: error at most 2 mrad
inline constexpr double kDeadBandStep = 3e-3;  ///< of a dead-band test, of which only the end is read [s]: error at most 2 %
inline constexpr double kLogStep = 5e-4;       ///< of a log [s]: error 2 mrad after 8 s of fast motion

/// The same step on a rig: as much longer as its time is (gap_case::Reference), at most kStepRange times as long or short beside its
/// phases, so that neither light motors make a diagnosis endless nor heavy ones end a phase in a few steps.
[[nodiscard]] double step_on(const gap_case::Reference& reference, const gap_case::Protocol& protocol, double step);
inline constexpr double kStepRange = 4.0;

/// Positions and speeds of the three bodies, and the hysteresis state of each spring.
struct MotionState {
    std::array<double, 3> place{}, speed{};  ///< of the agonist's capstan, the antagonist's, the joint [rad], [rad/s]
    std::array<Hysteresis, 4> memory;        ///< SE, PE of the agonist, SE, PE of the antagonist
    std::array<double, 4> relaxed{};         ///< torque of each, as its relaxation follows it [Nm]
    std::array<double, 2> slipped{};         ///< cable that slipped on each capstan [rad]
    std::array<bool, 2> jumped{};            ///< each cable has left its groove
    std::array<double, 2> encoder{};         ///< of each motor, as its gear's backlash takes it along; 0 without backlash [rad]
    [[nodiscard]] bool at_rest() const { return speed[0] == 0.0 && speed[1] == 0.0 && speed[2] == 0.0; }
};

/// A built rig in motion: J v' = torque - loads - friction, set-valued friction (a body below its limit does not move).
/// Symplectic Euler with the friction's impulse solved body by body (Moreau 1988): no numerical damping, no creep.
class Motion {
public:
    /// Begins at rest at angle 0 without torque, at a time of the session [s]. `rig` must outlive it.
    Motion(const BuiltRig& rig, double longest_step, double session = 0.0);

    struct Torques {
        double agonist = 0.0, antagonist = 0.0, joint = 0.0;  ///< commanded [Nm]
        [[nodiscard]] bool operator==(const Torques&) const = default;
    };
    /// Ramps the torques linearly to `torques` within `seconds`.
    void lead_to(const Torques& torques, double seconds);
    /// The same along 3 s^2 - 2 s^3, in linear pieces.
    void lead_smoothly_to(const Torques& torques, double seconds);
    void hold(double seconds) { lead_to(torques_, seconds); }

    [[nodiscard]] double theta(gap_case::Side side) const { return state_.place[static_cast<std::size_t>(side)]; }  ///< [rad]
    /// Angle of a capstan as the encoder of its motor has it, behind the backlash of the gear [rad].
    [[nodiscard]] double encoder(gap_case::Side side) const;
    [[nodiscard]] double q() const { return state_.place[2]; }            ///< [rad]
    [[nodiscard]] double joint_torque() const { return torques_.joint; }  ///< commanded [Nm]
    [[nodiscard]] double session() const { return session_; }             ///< [s]
    double hand_damping = 0.0;                                            ///< at the joint, of a hand that follows it [Nms/rad]

private:
    const BuiltRig* rig_;
    double longest_step_, session_;
    Torques torques_;
    MotionState state_;
};

}  // namespace fusee::joint_model
