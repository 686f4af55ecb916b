#include <algorithm>

#include "effect_kind.h"
#include "fusee/core/lists.h"
#include "fusee/core/units.h"

namespace fusee::plant {

namespace {

using R = const RigRange&;

double phase(Random& random) { return random.uniform(0.0, 2.0 * core::kPi); }

/// Other friction at a motor.
std::vector<EffectKind> outside_gear_kinds() {
    return {
        // One bad tooth: friction rises and falls once or a few times per turn of the capstan.
        {"outside.gear_ripple",
         [](R, Random& random, Effect& e) {
             e.size = random.uniform(0.45, 0.75);
             e.extra = {{"turns_per_rad", random.uniform(2.0, 6.0)}, {"phase_rad", phase(random)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.ripple = e.size;
             s.ripple_turns = e.parameter("turns_per_rad");
             s.ripple_phase = e.parameter("phase_rad");
         }},
        // The grease warms: friction falls, or rises as a bearing tightens, over the session.
        {"outside.friction_drift",
         [](R range, Random& random, Effect& e) {
             const double size = random.uniform(0.4, 0.6);
             e.size = range.nominal->mu > 0.35 ? -size : random.either_sign(size);
             e.extra = {{"time_s", random.uniform(150.0, 400.0)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.drift = e.size;
             s.drift_time = e.parameter("time_s");
         }},
    };
}

/// Other faults of drive, sensor or cable at a motor.
std::vector<EffectKind> capstan_kinds() {
    return {
        // The other motor's current leaks into this one's command.
        {"outside.crosstalk", [](R, Random& random, Effect& e) { e.size = random.either_sign(random.uniform(0.12, 0.2)); },
         [](const Effect& e, SideTruth& s) { s.crosstalk = e.size; }},
        // The magnets of the motor pull it to some angles.
        {"outside.cogging",
         [](R range, Random& random, Effect& e) {
             e.size = range.scale * random.uniform(0.03, 0.08);
             e.extra = {{"turns_per_rad", random.uniform(4.0, 14.0)}, {"phase_rad", phase(random)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.cogging = e.size;
             s.cogging_turns = e.parameter("turns_per_rad");
             s.cogging_phase = e.parameter("phase_rad");
         }},
        // Under tension the cable leaves its groove for the next one, once in a run.
        {"outside.groove_jump",
         [](R range, Random& random, Effect& e) {
             e.size = range.series * random.uniform(0.3, 0.55);
             e.extra = {{"lost_rad", random.uniform(0.15, 0.3)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.jump_torque = e.size;
             s.jump = e.parameter("lost_rad");
         }},
        // The encoder's disc sits off its centre.
        {"outside.encoder_eccentricity",
         [](R, Random& random, Effect& e) {
             e.size = random.uniform(0.09, 0.16);
             e.extra = {{"phase_rad", phase(random)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.eccentricity = e.size;
             s.eccentricity_phase = e.parameter("phase_rad");
         }},
        // The cable slips on its capstan above a tension, the faster the more of it, and does not come back.
        {"outside.capstan_slip",
         [](R range, Random& random, Effect& e) {
             e.size = range.series * random.uniform(0.6, 0.8);
             e.extra = {{"drag_Nms", random.uniform(0.8, 1.6)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.slip_torque = e.size;
             s.slip_drag = e.parameter("drag_Nms");
         }},
    };
}

/// Other faults of a spring or its cam.
std::vector<EffectKind> cam_kinds() {
    return {
        // A cracked cam: from one angle on its groove lies lower.
        {"outside.se_crack",
         [](R range, Random& random, Effect& e) {
             e.size = random.uniform(0.12, 0.2);
             e.extra = {{"spool_rad", range.spool * random.uniform(0.35, 0.65)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.se.crack_share = e.size;
             s.se.crack_at = e.parameter("spool_rad");
         }},
        {"outside.pe_crack",
         [](R range, Random& random, Effect& e) {
             e.size = random.uniform(0.12, 0.2);
             e.extra = {{"capstan_rad", range.travel * random.uniform(0.45, 0.7)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.pe.crack_share = e.size;
             s.pe.crack_at = e.parameter("capstan_rad");
         }},
        // A printed spring creeps: its torque relaxes by a share (standard linear solid).
        {"outside.pe_creep",
         [](R, Random& random, Effect& e) {
             e.size = random.uniform(0.25, 0.45);
             e.extra = {{"time_s", random.uniform(0.6, 2.5)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.pe.creep_share = e.size;
             s.pe.creep_time = e.parameter("time_s");
         }},
    };
}

std::vector<EffectKind> output_kinds() {
    return {
        // The wires to the hand: a spring from joint to ground that hardens.
        {"outside.harness",
         [](R range, Random& random, Effect& e) {
             e.size = random.uniform(0.08, 0.15);
             e.extra = {{"hardening_Nm_per_rad3", 1.5 * e.size / (range.reach * range.reach)}};
         },
         nullptr,
         [](const Effect& e, JointTruth& j) {
             j.harness = e.size;
             j.hardening = e.parameter("hardening_Nm_per_rad3");
         }},
        // A dent in the bearing: friction at one angle.
        {"outside.joint_rough_spot",
         [](R range, Random& random, Effect& e) {
             e.size = random.uniform(0.15, 0.25);
             e.extra = {{"at_rad", random.either_sign(range.reach * random.uniform(0.15, 0.25))},
                        {"width_rad", range.reach * random.uniform(0.08, 0.12)}};
         },
         nullptr,
         [](const Effect& e, JointTruth& j) {
             j.rough = e.size;
             j.rough_at = e.parameter("at_rad");
             j.rough_width = e.parameter("width_rad");
         }},
        // The pulley of the joint turns about a point off its centre.
        {"outside.eccentric_pulley",
         [](R, Random& random, Effect& e) {
             e.size = random.uniform(0.12, 0.25);
             e.extra = {{"phase_rad", phase(random)}};
         },
         nullptr,
         [](const Effect& e, JointTruth& j) {
             j.pulley = e.size;
             j.pulley_phase = e.parameter("phase_rad");
         }},
        // The link bends between the encoder and the torque.
        {"outside.joint_flexibility",
         [](R range, Random& random, Effect& e) { e.size = random.uniform(0.12, 0.25) * range.reach / range.most_push; }, nullptr,
         [](const Effect& e, JointTruth& j) { j.flexibility = e.size; }},
        // The log's channel of the joint is late.
        {"outside.clock_skew", [](R, Random& random, Effect& e) { e.size = random.uniform(0.03, 0.08); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.encoder_lag = e.size; }},
        // The joint's encoder counts too many or too few.
        {"outside.encoder_scale", [](R, Random& random, Effect& e) { e.size = random.either_sign(random.uniform(0.08, 0.15)); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.encoder_scale = 1.0 + e.size; }},
    };
}

/// The session's time within which a part has warmed up: long enough that the experiments see it change.
void draw_session_time(Random& random, Effect& e) { e.extra = {{"time_s", random.uniform(250.0, 600.0)}}; }

/// At a motor: no term and no effect of the library has these equations.
std::vector<EffectKind> form_blind_side_kinds() {
    return {
        // A warm magnet is weaker: the torque constant falls over the session.
        {"outside.motor_fade",
         [](R, Random& random, Effect& e) {
             e.size = -random.uniform(0.15, 0.25);
             draw_session_time(random, e);
         },
         [](const Effect& e, SideTruth& s) {
             s.fade = e.size;
             s.fade_time = e.parameter("time_s");
         }},
        // A warm spring is softer.
        {"outside.thermal_spring",
         [](R, Random& random, Effect& e) {
             e.size = -random.uniform(0.18, 0.3);
             draw_session_time(random, e);
         },
         [](const Effect& e, SideTruth& s) {
             s.se.warm_share = e.size;
             s.se.warm_time = e.parameter("time_s");
         }},
        // Iron saturates: the torque constant falls with the current.
        {"outside.magnetic_saturation", [](R range, Random& random, Effect& e) { e.size = range.scale * random.uniform(1.6, 2.4); },
         [](const Effect& e, SideTruth& s) { s.saturation = e.size; }},
        // A worm or a wet clutch: friction in proportion to the load rises with the speed.
        {"outside.friction_rise",
         [](R range, Random& random, Effect& e) {
             e.size = std::min(random.uniform(0.5, 1.0), 0.56 / range.nominal->mu - 1.0);
             e.extra = {{"speed_rad_per_s", random.uniform(0.1, 0.3)}};
         },
         [](const Effect& e, SideTruth& s) {
             s.rise = e.size;
             s.rise_speed = e.parameter("speed_rad_per_s");
         }},
    };
}

std::vector<EffectKind> form_blind_joint_kinds() {
    return {
        // The encoder's zero moves as its holder warms up.
        {"outside.zero_drift",
         [](R, Random& random, Effect& e) {
             e.size = random.either_sign(random.uniform(0.06, 0.12));
             draw_session_time(random, e);
         },
         nullptr,
         [](const Effect& e, JointTruth& j) {
             j.zero_drift = e.size;
             j.zero_time = e.parameter("time_s");
         }},
        // The disc of the joint's encoder sits off its centre.
        {"outside.joint_encoder_eccentricity",
         [](R, Random& random, Effect& e) {
             e.size = random.uniform(0.12, 0.2);
             e.extra = {{"phase_rad", phase(random)}};
         },
         nullptr,
         [](const Effect& e, JointTruth& j) {
             j.eccentricity = e.size;
             j.eccentricity_phase = e.parameter("phase_rad");
         }},
        // A paddle in a fluid.
        {"outside.quadratic_drag", [](R, Random& random, Effect& e) { e.size = random.uniform(0.05, 0.12); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.drag = e.size; }},
        // The plate that holds motors and joint gives way to both cables together; a spring on its bench does not see it.
        {"outside.mount", [](R, Random& random, Effect& e) { e.size = random.uniform(0.15, 0.3); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.mount = e.size; }},
    };
}

}  // namespace

const std::vector<EffectKind>& form_blind_kinds() {
    static const std::vector<EffectKind> all = core::joined(form_blind_side_kinds(), form_blind_joint_kinds());
    return all;
}

/// The plant's own machine has one angle for pulley and link.
const std::vector<EffectKind>& engine_kinds() {
    static const std::vector<EffectKind> all{
        // The key of the link's shaft is worn.
        {"outside.joint_play", [](R, Random& random, Effect& e) { e.size = random.uniform(0.04, 0.08); }, nullptr,
         [](const Effect& e, JointTruth& j) { j.play = e.size; }}};
    return all;
}

const std::vector<EffectKind>& outside_kinds() {
    static const std::vector<EffectKind> all = core::joined(outside_gear_kinds(), capstan_kinds(), cam_kinds(), output_kinds());
    return all;
}

}  // namespace fusee::plant
