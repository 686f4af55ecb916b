#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "fusee/core/units.h"
#include "law.h"

/// One log of a servo with a pendulum, and its motion in time (docs/subsystem-cases.md, eq. 4 to 6).
namespace fusee::subsystem {

inline constexpr double kGravity = 9.81;  // [m/s^2]

/// Places of the parameters that every servo has.
struct ServoParameter {
    enum : std::size_t {
        kTorqueConstant,
        kResistance,
        kArmature,
        kCoulomb,
        kViscous,
        kOffset,
        kLoop,
        kLoadFriction,
        kLoadQuadratic,
        kStribeck,
        kStribeckSpeed,
        kAsymmetry,
        kGain,
        kDelay,
        kGoals,
        kPlaces
    };
};

/// How goals run between two rows, as the value of the parameter `goals`.
struct Goals {
    static constexpr double kStraight = 0.0, kHeld = 1.0, kJumps = 2.0;  // the last: straight, but a jump comes with its row
};

/// Servos whose position loop is known: the duty for each kp and rad of error [1/rad].
struct KnownServo {
    const char* word;  // of motor=...
    const char* name;
    double duty_per_kp_rad;
};
inline constexpr KnownServo kXl330{"xl330", "DYNAMIXEL XL330", 4096.0 / (2.0 * core::kPi) / (256.0 * 885.0)};

/// A log: what the servo was told, from the first angle on.
struct Rollout {
    std::vector<double> time, goal;
    std::vector<bool> powered;
    double start = 0.0;
    double gravity = 0.0, load_inertia = 0.0;  // m g l [Nm], m l^2 [kg m^2]
    double kp = 0.0, supply = 0.0;             // [V]
    std::optional<double> duty;                // for each kp and rad of error; none: fitted
    std::vector<bool> jumps;                   // the goal of the row is far from that of the row before
    std::optional<double> goals;               // Goals; none: as the values say
};

/// @throws core::InvalidInput naming the file where the times make more steps than any prediction takes
[[nodiscard]] Rollout rollout_of(const Record& record);
/// Steps between two rows [s].
[[nodiscard]] std::size_t steps_between(double from, double to);
/// Steps of its simulation; at most a few more than `most`.
[[nodiscard]] std::size_t steps_of(const Rollout& roll, std::size_t most);
/// The angle of each row [rad]. @throws core::Stopped
void simulate(const Rollout& roll, const Values& values, std::vector<double>& predicted);

}  // namespace fusee::subsystem
