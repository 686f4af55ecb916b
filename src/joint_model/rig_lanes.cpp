#include "fusee/joint_model/rig_lanes.h"

namespace fusee::joint_model {

namespace {

template <class V, class Of>
bool any_rig(const RigsOf<V>& rigs, const Of& of) {
    return std::any_of(rigs.begin(), rigs.end(), [&](const BuiltRig* rig) { return of(*rig); });
}

}  // namespace

template <class V>
SideLanes<V>::SideLanes(const RigsOf<V>& rigs, std::size_t side) : se(rigs, side, &BuiltSide::se), pe(rigs, side, &BuiltSide::pe) {
    const auto of_gear = [&](double Gear::*figure) { return each<V>([&](std::size_t i) { return rigs[i]->sides[side].gear.*figure; }); };
    const auto of_side = [&](double BuiltSide::*figure) { return each<V>([&](std::size_t i) { return rigs[i]->sides[side].*figure; }); };
    ratio = of_side(&BuiltSide::ratio);
    capstan_scale = of_side(&BuiltSide::capstan_scale);
    motor_inertia = of_side(&BuiltSide::motor_inertia);
    load_friction = of_gear(&Gear::load_friction);
    coulomb = of_gear(&Gear::coulomb);
    quadratic = of_gear(&Gear::quadratic);
    asymmetry = of_gear(&Gear::asymmetry);
    stribeck = of_gear(&Gear::stribeck);
    viscous = of_gear(&Gear::viscous);
    torque_scale = of_gear(&Gear::torque_scale);
    saturation = of_gear(&Gear::saturation);
    half_backlash = 0.5 * of_gear(&Gear::backlash);
    se_hysteresis = each<V>([&](std::size_t i) { return rigs[i]->sides[side].se_build.hysteresis; });
    pe_hysteresis = each<V>([&](std::size_t i) { return rigs[i]->sides[side].pe_build.hysteresis; });
    moving_terms = any_rig<V>(rigs, [&](const BuiltRig& rig) { return rig.sides[side].gear.terms.move(); });
    has_stribeck = any(stribeck > 0.0);
}

template <class V>
RigLanes<V>::RigLanes(const RigsOf<V>& of) : rigs(of), sides{SideLanes<V>(of, 0), SideLanes<V>(of, 1)} {
    const auto figure = [&](double BuiltRig::*own) { return each<V>([&](std::size_t i) { return rigs[i]->*own; }); };
    joint_inertia = figure(&BuiltRig::joint_inertia);
    joint_coulomb = figure(&BuiltRig::joint_coulomb);
    tension_friction = figure(&BuiltRig::tension_friction);
    joint_viscous = figure(&BuiltRig::joint_viscous);
    stop = figure(&BuiltRig::stop);
    stop_stiffness = figure(&BuiltRig::stop_stiffness);
    stop_damping = figure(&BuiltRig::stop_damping);
    gravity = figure(&BuiltRig::gravity);
    half_play = each<V>([&](std::size_t i) { return 0.5 * rigs[i]->terms.play; });
    memory = each<V>([&](std::size_t i) { return rigs[i]->has_memory() ? 1.0 : 0.0; });
    remembers = any(memory > 0.0);
    for (const SideLanes<V>& side : sides) {
        hysteresis = hysteresis || any(side.se_hysteresis != 0.0) || any(side.pe_hysteresis != 0.0);
        backlash = backlash || any(side.half_backlash > 0.0);
    }
    arm = any_rig<V>(rigs, [](const BuiltRig& rig) { return rig.terms.arm.is_on(); });
    torque = any_rig<V>(rigs, [](const BuiltRig& rig) { return rig.terms.has_torque(); });
    drag = any_rig<V>(rigs, [](const BuiltRig& rig) { return rig.terms.drag != 0.0; });
    bump = any_rig<V>(rigs, [](const BuiltRig& rig) { return rig.terms.friction.is_on(); });
    has_gravity = any(gravity != 0.0);
    plays = any(half_play > 0.0);
}

template struct SideLanes<double>;
template struct SideLanes<Lanes>;
template struct RigLanes<double>;
template struct RigLanes<Lanes>;

}  // namespace fusee::joint_model
