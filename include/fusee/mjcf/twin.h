#pragma once
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "fusee/actuator/joint.h"
#include "fusee/core/provenance.h"
#include "fusee/joint_model/built_rig.h"
#include "fusee/mjcf/curve.h"

/// The joint as a model of the simulator MuJoCo, with the laws that its companion programs apply (docs/guides/mujoco.md).
namespace fusee::mjcf {

/// Friction of one gear with its motor, at the capstan.
struct TwinGear {
    std::vector<double> load, friction;  ///< friction in motion over |load|, linear between rows and beyond the last [Nm]
    double asymmetry = 0.0;              ///< (1 + a) times when winding in, (1 - a) when paying out
    double rest_excess = 0.0;            ///< at rest (1 + s) times, s exp(-(v/v_s)^2) in between
    double rest_speed = 0.01;            ///< v_s [rad/s]
    double viscous = 0.0;                ///< [Nms/rad]
    double torque_scale = 1.0;           ///< delivered torque over commanded torque
    double saturation = std::numeric_limits<double>::infinity();  ///< greatest torque delivered [Nm]
    double backlash = 0.0;                                        ///< between capstan and encoder [rad]

    [[nodiscard]] double at(double load) const;  ///< friction in motion [Nm]
};

struct TwinSide {
    double ratio = 1.0;          ///< g of this side: x_1 = s theta_1 + g q, x_2 = s theta_2 - g q
    double capstan_scale = 1.0;  ///< s
    double motor_inertia = 0.0;  ///< [kg m^2]
    TwinGear gear;
    Curve se, pe;
};

/// A joint as MuJoCo sees it: two capstans and the joint, each a hinge; a tendon for each spring. Signs: docs/gap.md.
struct Twin {
    std::string name, source;                               ///< of the model; the line that says what it was made from
    std::array<TwinSide, 2> sides;                          ///< agonist, antagonist
    double capstan_radius = 0.0;                            ///< [m], for the picture only
    double joint_inertia = 0.0;                             ///< [kg m^2]
    double joint_viscous = 0.0;                             ///< [Nms/rad]
    double joint_friction = 0.0;                            ///< constant friction of the joint [Nm]
    double tension_share = 0.0;                             ///< c of its friction c (g_1 F_SE,1 + g_2 F_SE,2)
    double gravity = 0.0;                                   ///< m g l of -m g l sin q [Nm]
    double stop = std::numeric_limits<double>::infinity();  ///< |q| at which a stop begins [rad]
    double stop_stiffness = 0.0, stop_damping = 0.0;        ///< [Nm/rad]; share of the critical damping
    double joint_offset = 0.0;                              ///< added to q as read [rad]
    double delay = 0.0;                                     ///< of every command [s]
    bool capstan_stops = false;                             ///< a capstan cannot turn below angle 0
    double reference_torque = 0.0;                          ///< co-contraction at which joint.xml has its constant friction [Nm]
    std::vector<std::string> not_expressed;                 ///< what fusee knows of the joint and the model leaves out, one sentence each
};

/// Step at which the stiffest motion of the twin advances by at most a tenth of a radian of its phase: 1, 2 or 5 times a power of ten, at
/// most 1e-3 s.
[[nodiscard]] double time_step(const Twin& twin);

/// Inertia, drag, co-contractions of a joint that has only springs and friction.
struct TwinMotion {
    double motor_inertia = 0.0, joint_inertia = 0.0;  ///< [kg m^2]
    double motor_viscous = 0.0, joint_viscous = 0.0;  ///< [Nms/rad]
    double reference_torque = 0.0;                    ///< [Nm]
};
/// The paper's joint. @pre its springs are those of actuator::antagonist
[[nodiscard]] Twin twin_of(const actuator::Joint& joint, const TwinMotion& motion);
/// A rig as built, with the effects that were applied to it. @pre rig.assemble was called
[[nodiscard]] Twin twin_of(const joint_model::BuiltRig& rig, double capstan_radius, double reference_torque);

}  // namespace fusee::mjcf
