#include <algorithm>

#include "effect_kind.h"
#include "fusee/core/lists.h"

namespace fusee::plant {

namespace {

/// Highest mu (1 + s): above it a load hardly drives the gear back, and a break-away test is out of range.
constexpr double kMostFriction = 0.56;

void draw_load_friction(const RigRange& range, Random& random, Effect& e) {
    const double size = random.uniform(0.3, 0.6);
    e.size = range.nominal->mu * (1.0 + size) > kMostFriction ? -size : random.either_sign(size);
}
void draw_stribeck(const RigRange& range, Random& random, Effect& e) {
    e.size = std::min(random.uniform(0.5, 1.1), kMostFriction / range.nominal->mu - 1.0);
    e.extra = {{"speed_rad_per_s", random.uniform(0.02, 0.2)}};
}
double part(double of, double low, double high, Random& random) { return of * random.uniform(low, high); }

std::vector<EffectKind> gear_kinds() {
    using R = const RigRange&;
    return {
        {"gear.load_friction", draw_load_friction, [](const Effect& e, SideTruth& s) { s.mu *= 1.0 + e.size; }},
        {"gear.coulomb", [](R range, Random& random, Effect& e) { e.size = part(range.scale, 0.04, 0.065, random); },
         [](const Effect& e, SideTruth& s) { s.coulomb += e.size; }},
        {"gear.stribeck", draw_stribeck,
         [](const Effect& e, SideTruth& s) {
             s.stribeck = e.size;
             s.stribeck_speed = e.parameter("speed_rad_per_s");
         }},
        {"gear.viscous", [](R, Random& random, Effect& e) { e.size = random.uniform(0.04, 0.08); },
         [](const Effect& e, SideTruth& s) { s.viscous += e.size; }},
        {"cable.stretch", [](R, Random& random, Effect& e) { e.size = random.uniform(0.8, 2.0); },
         [](const Effect& e, SideTruth& s) { s.se.cable_stiffness = e.size; }},
        {"sensor.torque_scale", [](R, Random& random, Effect& e) { e.size = random.either_sign(random.uniform(0.12, 0.19)); },
         [](const Effect& e, SideTruth& s) { s.torque_scale *= 1.0 + e.size; }},
    };
}

std::vector<EffectKind> joint_kinds() {
    using R = const RigRange&;
    return {
        {"joint.coulomb", [](R, Random& random, Effect& e) { e.size = random.uniform(0.06, 0.1); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.coulomb += e.size; }},
        {"joint.viscous", [](R, Random& random, Effect& e) { e.size = random.uniform(0.02, 0.05); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.viscous += e.size; }},
        {"joint.stop", [](R range, Random& random, Effect& e) { e.size = part(range.reach, 0.2, 0.35, random); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.stop = e.size; }},
        {"joint.gravity", [](R, Random& random, Effect& e) { e.size = random.uniform(0.12, 0.2); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.gravity = e.size; }},
        {"cable.tension_friction", [](R, Random& random, Effect& e) { e.size = random.uniform(0.1, 0.16); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.tension_friction = e.size; }},
        {"sensor.joint_offset", [](R, Random& random, Effect& e) { e.size = random.either_sign(random.uniform(0.03, 0.06)); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.encoder_offset += e.size; }},
    };
}

std::vector<EffectKind> spring_kinds() {
    using R = const RigRange&;
    return {
        {"se.rate", [](R, Random& random, Effect& e) { e.size = random.either_sign(random.uniform(0.08, 0.16)); },
         [](const Effect& e, SideTruth& s) { s.se.rate *= 1.0 + e.size; }},
        {"pe.rate", [](R, Random& random, Effect& e) { e.size = random.either_sign(random.uniform(0.08, 0.16)); },
         [](const Effect& e, SideTruth& s) { s.pe.rate *= 1.0 + e.size; }},
        {"se.radius", [](R range, Random& random, Effect& e) { e.size = random.either_sign(part(range.se_arm, 0.055, 0.085, random)); },
         [](const Effect& e, SideTruth& s) { s.se.radius_offset += e.size; }},
        {"pe.radius", [](R range, Random& random, Effect& e) { e.size = random.either_sign(part(range.pe_arm, 0.05, 0.075, random)); },
         [](const Effect& e, SideTruth& s) { s.pe.radius_offset += e.size; }},
        {"se.preload", [](R range, Random& random, Effect& e) { e.size = random.either_sign(part(range.spool, 0.09, 0.13, random)); },
         [](const Effect& e, SideTruth& s) { s.se.preload += e.size; }},
        {"pe.preload", [](R range, Random& random, Effect& e) { e.size = random.either_sign(part(range.stroke, 0.07, 0.1, random)); },
         [](const Effect& e, SideTruth& s) { s.pe.preload += e.size; }},
        {"se.hysteresis", [](R, Random& random, Effect& e) { e.size = random.uniform(0.06, 0.15); },
         [](const Effect& e, SideTruth& s) { s.se.hysteresis = e.size; }},
        {"pe.hysteresis", [](R, Random& random, Effect& e) { e.size = random.uniform(0.08, 0.15); },
         [](const Effect& e, SideTruth& s) { s.pe.hysteresis = e.size; }},
        {"pe.bottoming", [](R range, Random& random, Effect& e) { e.size = part(range.stroke, 0.6, 0.75, random); },
         [](const Effect& e, SideTruth& s) { s.pe.bottoming = e.size; }},
    };
}

}  // namespace

/// By what a drawing, a data sheet or a weighed mass is usually wrong. A radius is that of the joint on its side; an inertia is half to
/// twice the stated one. No experiment shows a wrong drag of the joint, of 0.002 Nms.
const std::vector<EffectKind>& figure_kinds() {
    using R = const RigRange&;
    constexpr auto inertia = [](R, Random& random, Effect& e) {
        const double factor = random.uniform(1.5, 2.0);
        e.size = random.below(2) == 0 ? factor - 1.0 : 1.0 / factor - 1.0;
    };
    static const std::vector<EffectKind> all{
        {"figure.joint_radius", [](R, Random& random, Effect& e) { e.size = random.either_sign(random.uniform(0.02, 0.05)); },
         [](const Effect& e, SideTruth& s) { s.joint_radius *= 1.0 + e.size; }},
        {"figure.motor_inertia", inertia, [](const Effect& e, SideTruth& s) { s.inertia *= 1.0 + e.size; }},
        {"figure.joint_inertia", inertia, nullptr, [](const Effect& e, JointTruth& j) { j.inertia *= 1.0 + e.size; }},
    };
    return all;
}

const std::vector<EffectKind>& library_kinds() {
    static const std::vector<EffectKind> all = core::joined(gear_kinds(), joint_kinds(), spring_kinds());
    return all;
}

}  // namespace fusee::plant
