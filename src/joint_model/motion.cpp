#include "fusee/joint_model/motion.h"

#include <algorithm>
#include <cmath>

namespace fusee::joint_model {

namespace {

template <class V>
using TorquesOf = typename MotionOf<V>::Torques;

template <class V>
TorquesOf<V> between(const TorquesOf<V>& from, const TorquesOf<V>& to, V share) {
    return {from.agonist + share * (to.agonist - from.agonist), from.antagonist + share * (to.antagonist - from.antagonist),
            from.joint + share * (to.joint - from.joint)};
}

constexpr double kPulleyShare = 0.1;  ///< of the joint's inertia where the link has play; the link has the rest

/// Steps of equal length `h` in each lane. This is the innermost loop of a diagnosis.
template <class V>
class Stepper {
public:
    Stepper(const RigLanes<V>& rig, V hand_damping, V h, V session) : rig_(rig), h_(h), hand_damping_(hand_damping) {
        for (std::size_t i = 0; i < 2; ++i) {
            per_mass_[i] = 1.0 / (rig.sides[i].motor_inertia + h * rig.sides[i].viscous);
            const auto factor = [&](auto&& drift_of) {
                return each<V>([&](std::size_t l) { return drift_of(rig.rigs[l]->sides[i]).factor(lane(session, l)); });
            };
            friction_[i] = factor([](const BuiltSide& side) -> const Drift& { return side.gear.terms.friction_drift; });
            delivered_[i] = factor([](const BuiltSide& side) -> const Drift& { return side.gear.terms.torque_drift; });
            series_[i] = factor([](const BuiltSide& side) -> const Drift& { return side.se_terms.drift; });
            parallel_[i] = factor([](const BuiltSide& side) -> const Drift& { return side.pe_terms.drift; });
        }
        free_mass_ = rig.joint_inertia + h * (rig.joint_viscous + hand_damping);
        per_free_mass_ = 1.0 / free_mass_;
    }

    [[nodiscard]] Mask<V> remembers() const { return (rig_.memory > 0.0) | (rig_.half_play > 0.0); }
    /// Equations 1 to 4 of docs/theory/diagnosis.md.
    void step(MotionState<V>& s, const TorquesOf<V>& torques) const {
        const std::array<V, 2> pull{turn_capstan<0>(s, torques.agonist, torques.antagonist),
                                    turn_capstan<1>(s, torques.antagonist, torques.agonist)};
        turn_joint(s, pull, torques.joint);
        for (std::size_t i = 0; i < 3; ++i) s.place[i] += h_ * s.speed[i];
        for (std::size_t i = 0; i < 2; ++i) {  // the preload stop
            s.speed[i] = s.place[i] < 0.0 ? V{} : s.speed[i];
            s.place[i] = s.place[i] < 0.0 ? V{} : s.place[i];
        }
        if (!rig_.backlash) return;
        for (std::size_t i = 0; i < 2; ++i) {
            const V half = rig_.sides[i].half_backlash;
            s.encoder[i] = clamped(s.encoder[i], s.place[i] - half, s.place[i] + half);
        }
    }

private:
    /// New speed of a capstan. @return torque of its K_SE [Nm of nominal capstan]
    template <std::size_t kSide>
    V turn_capstan(MotionState<V>& s, V command, V other_command) const {
        const SideLanes<V>& side = rig_.sides[kSide];
        const V theta = s.place[kSide], wound = side.capstan_scale * theta, stretch = side.ratio * wound_on_joint(s.place[2]);
        const V x = (kSide == 0 ? wound + stretch : wound - stretch) - s.slipped[kSide];
        V pull = side.se.torque(x) * series_[kSide], parallel = side.pe.torque(theta) * parallel_[kSide];
        if (rig_.hysteresis) {
            pull = s.hysteresis[2 * kSide].torque(x, pull, side.se_hysteresis);
            parallel = s.hysteresis[2 * kSide + 1].torque(theta, parallel, side.pe_hysteresis);
        }
        if (rig_.remembers)
            for (std::size_t l = 0; l < kWidth<V>; ++l) remember<kSide>(s, l, pull, parallel);
        V extra{}, factor = friction_[kSide];
        if (side.moving_terms) {
            extra = each<V>([&](std::size_t l) {
                const GearTerms& terms = rig_.rigs[l]->sides[kSide].gear.terms;
                return terms.torque(lane(theta, l)) + terms.crosstalk * lane(other_command, l);
            });
            factor *=
                each<V>([&](std::size_t l) { return std::max(0.0, 1.0 + rig_.rigs[l]->sides[kSide].gear.terms.friction(lane(theta, l))); });
        }
        const V load = side.capstan_scale * pull + parallel;
        s.speed[kSide] = gear_speed<kSide>(s.speed[kSide], load, {command * delivered_[kSide], extra, factor});
        return pull;
    }
    /// Relaxation of both springs and slip of the cable, from the torques of this step.
    template <std::size_t kSide>
    void remember(MotionState<V>& s, std::size_t l, V& pull, V& parallel) const {
        const BuiltSide& side = rig_.rigs[l]->sides[kSide];
        const double h = lane(h_, l);
        const auto relax = [h, l](V& relaxed, V& torque, const SpringTerms& terms) {
            const double following = lane(relaxed, l) + h / (terms.relaxation_time + h) * (lane(torque, l) - lane(relaxed, l));
            set_lane(relaxed, l, following);
            set_lane(torque, l, terms.relaxed(lane(torque, l), following));
        };
        if (!rig_.rigs[l]->has_memory()) return;
        relax(s.relaxed[2 * kSide], pull, side.se_terms);
        relax(s.relaxed[2 * kSide + 1], parallel, side.pe_terms);
        double slipped = lane(s.slipped[kSide], l);
        if (lane(s.jumped[kSide], l) == 0.0 && lane(pull, l) > side.se_terms.jump_at) {
            set_lane(s.jumped[kSide], l, 1.0);
            slipped += side.se_terms.jump;
        }
        slipped += h * std::max(0.0, lane(pull, l) - side.se_terms.slip_at) / side.se_terms.slip_drag;
        set_lane(s.slipped[kSide], l, slipped);
    }
    /// The joint angle that would wind as much cable on the nominal arm.
    [[nodiscard]] V wound_on_joint(V q) const {
        if (!rig_.arm) return q;
        return each<V>([&](std::size_t l) {
            const Ripple& arm = rig_.rigs[l]->terms.arm;
            return arm.is_on() ? lane(q, l) + arm.integral(lane(q, l)) : lane(q, l);
        });
    }
    struct Drive {
        V command, extra, friction;  // [Nm], [Nm] of generic terms, factor of the friction
    };
    template <std::size_t kSide>
    [[nodiscard]] V gear_speed(V before, V load, const Drive& drive) const {
        const SideLanes<V>& gear = rig_.sides[kSide];
        const V torque = clamped(drive.command * (1.0 + gear.torque_scale), -gear.saturation, gear.saturation) + drive.extra;
        const V momentum = gear.motor_inertia * before + h_ * (torque - load);
        const V way = momentum < 0.0 ? V{} - 1.0 : V{} + 1.0;
        const V sliding = h_ * drive.friction * (gear.coulomb + gear.load_friction * magnitude(load) + gear.quadratic * load * load) *
                          (1.0 + way * gear.asymmetry);
        const V left = magnitude(momentum) - sliding;
        const Mask<V> rests = (left <= 0.0) | ((left <= sliding * gear.stribeck) & (before * way <= 0.0));
        V speed = left * per_mass_[kSide];
        if (gear.has_stribeck && any(!rests))
            for (int i = 0; i < 3; ++i)
                speed = greater(V{}, (left - sliding * gear.stribeck * stribeck_share<kSide>(speed)) * per_mass_[kSide]);
        return rests ? V{} : way * speed;
    }
    template <std::size_t kSide>
    [[nodiscard]] V stribeck_share(V speed) const {
        return each<V>([&](std::size_t l) {
            const double share = lane(speed, l) / rig_.rigs[l]->sides[kSide].gear.stribeck_speed;
            return std::exp(-share * share);
        });
    }
    void turn_joint(MotionState<V>& s, const std::array<V, 2>& pull, V command) const {
        const V q = s.place[2];
        const std::array<V, 2> torque{rig_.sides[0].ratio * pull[0], rig_.sides[1].ratio * pull[1]};
        V drive = torque[1] - torque[0];
        if (rig_.arm)
            drive *= of_terms([&](const JointTerms& terms, double at) { return terms.arm.is_on() ? 1.0 + terms.arm(at) : 1.0; }, q);
        drive += command;
        if (rig_.torque)
            drive += of_terms([&](const JointTerms& terms, double at) { return terms.has_torque() ? terms.torque_at(at) : 0.0; }, q);
        V mass = free_mass_, per_mass = per_free_mass_;
        if (rig_.drag) {
            mass +=
                h_ * of_terms([](const JointTerms& terms, double at) { return terms.drag != 0.0 ? terms.drag_at(at) : 0.0; }, s.speed[2]);
            per_mass = 1.0 / mass;
        }
        if (const V inside = magnitude(q) - rig_.stop; any(inside > 0.0)) {
            const V drag = h_ * 2.0 * rig_.stop_damping *
                           each<V>([&](std::size_t l) { return std::sqrt(lane(rig_.stop_stiffness, l) * lane(rig_.joint_inertia, l)); });
            drive = inside > 0.0 ? drive - with_sign(rig_.stop_stiffness * inside, q) : drive;
            per_mass = inside > 0.0 ? 1.0 / (mass + drag) : per_mass;
        }
        if (rig_.has_gravity) {
            const V sine = each<V>([&](std::size_t l) { return std::sin(lane(q, l)); });
            drive = rig_.gravity != 0.0 ? drive - rig_.gravity * sine : drive;
        }
        const V momentum = rig_.joint_inertia * s.speed[2] + h_ * drive;
        V friction = h_ * (rig_.joint_coulomb + rig_.tension_friction * (torque[0] + torque[1]));
        if (rig_.bump) friction = bumped(friction, q);
        const V before = s.speed[2];
        s.speed[2] = with_sign(greater(V{}, magnitude(momentum) - friction), momentum) * per_mass;
        if (rig_.plays) part(s, before, {drive, command, friction, per_mass});
    }
    struct Parts {
        V drive, command, friction, per_mass;  // of both, of the link alone [Nm], of the pulley [Nms], of both
    };
    /// Where the link has play: pulley and link each move alone as long as that does not lead beyond the play, else as one.
    void part(MotionState<V>& s, V before, const Parts& parts) const {
        const V pulley = kPulleyShare * rig_.joint_inertia, link = rig_.joint_inertia - pulley;
        const V momentum = pulley * before + h_ * (parts.drive - parts.command), both = momentum + link * s.turning + h_ * parts.command;
        const V alone = with_sign(greater(V{}, magnitude(momentum) - parts.friction), momentum) / (pulley + h_ * rig_.joint_viscous);
        const V free = (link * s.turning + h_ * parts.command) / (link + h_ * hand_damping_);
        const V turned = s.turned + h_ * (free - alone);
        const Mask<V> apart = magnitude(turned) < rig_.half_play;
        s.turned = clamped(turned, -rig_.half_play, rig_.half_play);
        const V as_one = with_sign(greater(V{}, magnitude(both) - parts.friction), both) * parts.per_mass;
        s.speed[2] = apart ? alone : rig_.half_play > 0.0 ? as_one : s.speed[2];
        s.turning = apart ? free : s.speed[2];
    }
    template <class Of>
    [[nodiscard]] V of_terms(const Of& of, V q) const {
        return each<V>([&](std::size_t l) { return of(rig_.rigs[l]->terms, lane(q, l)); });
    }
    [[nodiscard]] V bumped(V friction, V q) const {
        return each<V>([&](std::size_t l) {
            const Bump& bump = rig_.rigs[l]->terms.friction;
            return bump.is_on() ? std::max(0.0, lane(friction, l) + lane(h_, l) * bump(lane(q, l))) : lane(friction, l);
        });
    }

    const RigLanes<V>& rig_;
    V h_, hand_damping_, free_mass_{}, per_free_mass_{};
    std::array<V, 2> per_mass_{};
    std::array<V, 2> friction_{}, delivered_{}, series_{}, parallel_{};  ///< factors that drift slowly: constant within these steps
};

/// The lanes `moving` of the next state; the others stay.
template <class V>
void take(MotionState<V>& s, const MotionState<V>& next, Mask<V> moving) {
    const auto choose = [&](auto& here, const auto& there) {
        for (std::size_t i = 0; i < here.size(); ++i) here[i] = moving ? there[i] : here[i];
    };
    choose(s.place, next.place);
    choose(s.speed, next.speed);
    choose(s.relaxed, next.relaxed);
    choose(s.slipped, next.slipped);
    choose(s.jumped, next.jumped);
    choose(s.encoder, next.encoder);
    s.turned = moving ? next.turned : s.turned;
    s.turning = moving ? next.turning : s.turning;
    for (std::size_t i = 0; i < s.hysteresis.size(); ++i) {
        s.hysteresis[i].last = moving ? next.hysteresis[i].last : s.hysteresis[i].last;
        s.hysteresis[i].z = moving ? next.hysteresis[i].z : s.hysteresis[i].z;
    }
}

template <class V>
struct TorqueRamp {
    TorquesOf<V> from, to;
    V steps;
};

template <class V>
inline void step_along(const Stepper<V>& stepper, const TorqueRamp<V>& ramp, MotionState<V>& begin) {
    const Mask<V> held = (ramp.from.agonist == ramp.to.agonist) & (ramp.from.antagonist == ramp.to.antagonist) &
                         (ramp.from.joint == ramp.to.joint) & !stepper.remembers();
    MotionState<V> state = begin;
    double i = 1.0;
    if (!any(held))  // no lane may end before it has made all steps
        for (const double all = least(ramp.steps); i <= all; ++i) stepper.step(state, between<V>(ramp.from, ramp.to, i / ramp.steps));
    for (;; ++i) {
        Mask<V> moving = i <= ramp.steps;
        if (i > 1.0 && any(held)) moving = moving & !(held & (state.speed[0] == 0.0) & (state.speed[1] == 0.0) & (state.speed[2] == 0.0));
        if (!any(moving)) break;
        const TorquesOf<V> now = between<V>(ramp.from, ramp.to, i / ramp.steps);
        if (!any(!moving)) {
            stepper.step(state, now);
            continue;
        }
        MotionState<V> next = state;
        stepper.step(next, now);
        take(state, next, moving);
    }
    begin = state;
}

void lead(const Stepper<double>& stepper, const TorqueRamp<double>& ramp, MotionState<double>& state) { step_along(stepper, ramp, state); }

// One function with all that it calls, as Lanes are handed over in other registers with AVX. The sanitizers and ifunc exclude each other.
#if defined(__x86_64__) && defined(__OPTIMIZE__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
[[gnu::flatten, gnu::target_clones("avx2", "default")]]
#endif
void lead(const Stepper<Lanes>& stepper, const TorqueRamp<Lanes>& ramp, MotionState<Lanes>& state) {
    step_along(stepper, ramp, state);
}

}  // namespace

double step_on(const gap_case::Reference& reference, const gap_case::Protocol& protocol, double step) {
    const auto duration = [](const gap_case::Protocol& p) {
        return p.motor_ramp + p.motor_settle + p.dead_band_push + p.dead_band_release + p.joint_stiffness_phase + p.cocontraction_phase;
    };
    const double phases = duration(protocol) / duration({});
    return step * std::clamp(reference.time, phases / kStepRange, phases * kStepRange);
}

template <class V>
MotionOf<V>::MotionOf(const RigsOf<V>& rigs, double longest_step, V session) : rig_(rigs), longest_step_(longest_step), session_(session) {}

template <class V>
void MotionOf<V>::lead_to(const Torques& torques, V seconds) {
    const V steps =
        each<V>([&](std::size_t l) { return lane(seconds, l) > 0.0 ? std::max(1.0, std::ceil(lane(seconds, l) / longest_step_)) : 0.0; });
    const Stepper<V> stepper(rig_, hand_damping, seconds / steps, session_);
    lead(stepper, TorqueRamp<V>{torques_, torques, steps}, state_);
    torques_ = torques;
    session_ += greater(V{}, seconds);
}

template <class V>
V MotionOf<V>::encoder(gap_case::Side side) const {
    const auto i = static_cast<std::size_t>(side);
    return rig_.sides[i].half_backlash > 0.0 ? state_.encoder[i] : state_.place[i];
}

template <class V>
void MotionOf<V>::lead_smoothly_to(const Torques& torques, V seconds) {
    constexpr int kPieces = 24;
    const Torques from = torques_;
    for (int i = 1; i <= kPieces; ++i) {
        const double s = static_cast<double>(i) / kPieces;
        lead_to(between<V>(from, torques, in_all<V>(s * s * (3.0 - 2.0 * s))), seconds / kPieces);
    }
}

template class MotionOf<double>;
template class MotionOf<Lanes>;

}  // namespace fusee::joint_model
