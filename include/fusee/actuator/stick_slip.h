#pragma once
#include <Eigen/Core>
#include <limits>

#include "fusee/actuator/joint.h"

/// Example:
/// @code
/// const actuator::Joint joint = pipeline::joint_of(design);  // springs, gears and bearing of a profile
/// const actuator::ReleaseReading read = actuator::release_test(joint, 1.0);  // co-contraction 1 Nm, a full push
/// std::cout << read.width() << ' ' << read.full_push << '\n';  // [rad], [Nm]
/// actuator::StickSlip path(joint);
/// path.lead_to({1.0, 1.0, 0.0});  // co-contract from rest
/// path.lead_to({1.0, 1.0, 0.1});  // push the joint
/// path.lead_to({1.0, 1.0, 0.0});  // release it
/// std::cout << path.z()[2] << '\n';  // where it stays [rad]
/// @endcode
namespace fusee::actuator {

/// A joint moved so slowly that inertia does not matter, with all its friction. Each capstan is a play with the loads of its friction law
/// at the motor torque as limits; the output is one with its bearing's friction as limits. Each step finds the place nearest to the last
/// one (bodies that need not move stay) at which no body is pushed beyond its friction:
///     load_i in resting_loads(tau_i) where capstan i stayed, load_i at the limit in motion where it slid (docs/theory/stick_slip.md)
/// Rate-independent: only the path of the torques counts.
class StickSlip {
public:
    /// Begins at rest at `z` without torque.
    explicit StickSlip(Joint joint, const Eigen::Vector3d& z = Eigen::Vector3d::Zero());

    /// Moves the torques straight to `torque` in `steps` equal steps.
    /// @throws InvalidInput if a torque is not finite or steps < 1
    void lead_to(const Eigen::Vector3d& torque, int steps = 32);

    [[nodiscard]] const Eigen::Vector3d& z() const { return z_; }              ///< (theta_1, theta_2, q) [rad]
    [[nodiscard]] const Eigen::Vector3d& torque() const { return torque_; }    ///< now applied [Nm]
    [[nodiscard]] const Eigen::Vector3d& sliding() const { return sliding_; }  ///< +1, -1: slid that way in the last step; 0: stayed
    /// False once the joint has run away from a push that its gears do not hold.
    [[nodiscard]] bool held() const { return held_; }
    /// False once a spring went beyond the end of its law (slack counts as inside) or a body ran away because no spring stopped it.
    [[nodiscard]] bool inside() const { return inside_; }
    [[nodiscard]] const Joint& joint() const { return joint_; }

private:
    void step(const Eigen::Vector3d& torque, const Eigen::Vector3d& guess);
    Joint joint_;
    Eigen::Vector3d z_, torque_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d sliding_ = Eigen::Vector3d::Zero();
    bool inside_ = true, held_ = true;
};

/// A push-and-release test (paper, tables I and II): co-contract from rest, push the joint up, hold, release slowly, read q; then push it
/// down from there, hold, release, read.
struct ReleaseTest {
    double push_torque = 0.0;    ///< at the joint [Nm]; 0: 1.05 times the full push
    int steps = 48;              ///< of each stroke; affect the reading only through rest excess and tension (stick_slip.md)
    bool find_full_push = true;  ///< false and a push given: full_push and covered_push stay NaN; takes a fifth of the time
};

struct ReleaseReading {
    double tau = 0.0;          ///< co-contraction [Nm]
    double push_torque = 0.0;  ///< as used [Nm]; 0: the springs' laws do not cover the co-contraction, and nothing is read
    /// Least push above which the reading stays the same (to 0.1 %) [Nm]; NaN if the joint runs away before.
    double full_push = std::numeric_limits<double>::quiet_NaN();
    /// Strongest push at which no spring goes beyond the end of its law [Nm]; not searched beyond the used push.
    double covered_push = std::numeric_limits<double>::quiet_NaN();
    double q_low = 0.0;   ///< read after the push to -q [rad]
    double q_high = 0.0;  ///< read after the push to +q [rad]
    bool inside = true;   ///< no spring went beyond its law's end on the way (beyond, it continues straight), and no body ran away
    [[nodiscard]] double width() const { return q_high - q_low; }
    [[nodiscard]] bool strong_enough() const { return push_torque >= full_push; }
};
/// @throws InvalidInput unless tau > 0, push_torque >= 0 and steps >= 1
[[nodiscard]] ReleaseReading release_test(const Joint& joint, double tau, const ReleaseTest& test = {});

}  // namespace fusee::actuator
