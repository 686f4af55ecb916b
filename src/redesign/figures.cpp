#include "figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/gap/effect.h"
#include "fusee/profile/edit.h"

namespace fusee::redesign {

namespace {

using gap::BuiltRig;
using Of = Figure::Of;

constexpr double kNothing = 1e-12;  // rounding of figures that an effect does not change

#define VALUE(of) [](const BuiltRig& rig, [[maybe_unused]] int side) { return rig.of; }

std::vector<Figure> all_figures() {
    return {
        {"rig.gear_friction", "gear load friction", Of::kGear, true, true, VALUE(sides[side].gear.load_friction)},
        {"rig.gear_friction_constant_Nm", "", Of::kGear, false, true, VALUE(sides[side].gear.coulomb)},
        {"rig.gear_friction_rest_excess", "", Of::kGear, false, true, VALUE(sides[side].gear.stribeck)},
        {"dynamics.motor_viscous_Nms", "", Of::kGear, false, false, VALUE(sides[side].gear.viscous)},
        {"k_se.spring.rate_Nm_per_rad", "K_SE rate", Of::kSpring, true, true, VALUE(sides[side].se_build.rate + 1.0)},
        {"k_se.spring.preload_rad", "K_SE preload", Of::kSpring, false, true, VALUE(sides[side].se_build.preload)},
        {"k_se.radius_allowance_mm", "K_SE radius", Of::kSpring, false, true, VALUE(sides[side].se_build.radius)},
        {"k_se.cable_compliance_rad_per_Nm", "", Of::kSpring, false, true, VALUE(sides[side].se_build.stretch)},
        {"k_pe.spring.rate_N_per_m", "K_PE rate", Of::kSpring, true, true, VALUE(sides[side].pe_build.rate + 1.0)},
        {"k_pe.spring.preload_mm", "K_PE preload", Of::kSpring, false, true, VALUE(sides[side].pe_build.preload)},
        {"k_pe.radius_allowance_mm", "K_PE radius", Of::kSpring, false, true, VALUE(sides[side].pe_build.radius)},
        {"rig.joint_friction_Nm", "", Of::kJoint, false, false, VALUE(joint_coulomb)},
        {"rig.joint_tension_friction", "", Of::kJoint, false, false, VALUE(tension_friction)},
        {"dynamics.joint_viscous_Nms", "", Of::kJoint, false, false, VALUE(joint_viscous)},
    };
}

#undef VALUE

void put(const gap::FoundEffect& found, BuiltRig& rig) {
    const gap::Effect& effect = gap::find_effect(found.cause.id);
    std::vector<double> values{found.parameter.value};
    for (std::size_t i = 1; i < effect.parameters.size(); ++i) {
        const auto given = std::find_if(found.extra.begin(), found.extra.end(),
                                        [&](const auto& named) { return named.first == effect.parameters[i].name; });
        values.push_back(given != found.extra.end() ? given->second : effect.parameters[i].at_first);
    }
    gap::apply_effect(effect, found.cause, values, rig);
}

double departure(const Figure& figure, const BuiltRig& nominal, const BuiltRig& built, int side) {
    const double was = figure.value(nominal, side), change = figure.value(built, side) - was;
    if (!figure.relative) return change;
    return was == 0.0 ? 0.0 : change / was;
}

bool touches(const Figure& figure, const BuiltRig& nominal, const gap::FoundEffect& found) {
    BuiltRig alone = nominal;
    put(found, alone);
    return std::max(std::abs(departure(figure, nominal, alone, 0)), std::abs(departure(figure, nominal, alone, 1))) > kNothing;
}

/// "gear.load_friction on both sides 0.3 (95 %: 0.28 to 0.32)"
std::string effect_text(const gap::FoundEffect& found) {
    const std::string side = found.cause.side == "none"   ? ""
                             : found.cause.side == "both" ? " on both sides"
                                                          : " on the " + found.cause.side;
    const std::string unit = found.parameter.unit.empty() || found.parameter.unit == "1" ? "" : " " + found.parameter.unit;
    const core::Range& ci = found.parameter.ci95;
    const std::string interval = std::isfinite(ci.low + ci.high) ? fmt::format(" (95 %: {:.4g} to {:.4g})", ci.low, ci.high) : "";
    return fmt::format("{}{} {:.4g}{}{}", found.cause.id, side, found.parameter.value, unit, interval);
}

/// Departures by the fitted build of the rig, each side. Friction is given in mu, not relative.
std::array<double, 2> of_build(const Figure& figure, const gap::Case& bench, const gap::Diagnosis& found, bool equal_on_both) {
    std::array<double, 2> all{};
    if (figure.build.empty()) return all;
    for (const int side : {0, 1})
        for (const auto& [name, parameter] : found.build)
            if (name == figure.build + " " + to_string(static_cast<gap::Side>(side))) all[side] = parameter.value;
    if (equal_on_both) all.fill(0.5 * (all[0] + all[1]));
    const double mu = bench.rig.gear_load_friction;
    if (figure.of == Of::kGear)
        for (double& value : all) value = mu > 0.0 ? value / mu : 0.0;
    return all;
}

/// K_PE's share of a longer arm below the profile's stop.
void press_by_radius(double rest_deflection, std::vector<Departure>& all) {
    const auto of = [&all](const char* key) -> Departure& {
        const auto at = std::find_if(figures().begin(), figures().end(), [key](const Figure& figure) { return figure.key == key; });
        return all[static_cast<std::size_t>(at - figures().begin())];
    };
    const Departure& radius = of("k_pe.radius_allowance_mm");
    Departure& preload = of("k_pe.spring.preload_mm");
    if (!radius.any()) return;
    for (const int side : {0, 1}) preload.on_side[side] += rest_deflection * radius.on_side[side];
    preload.why += (preload.why.empty() ? "" : ", ") + radius.why + fmt::format(", by {:.4g} rad up to the stop", rest_deflection);
}

}  // namespace

const std::vector<Figure>& figures() {
    static const std::vector<Figure> all = all_figures();
    return all;
}

std::vector<Departure> departures(const gap::Case& bench, const gap::Diagnosis& found, double rest_deflection) {
    const BuiltRig nominal(bench.rig);
    BuiltRig built = nominal;
    for (const gap::FoundEffect& effect : found.effects) put(effect, built);
    std::vector<Departure> all;
    for (const Figure& figure : figures()) {
        Departure& d = all.emplace_back();
        for (const gap::FoundEffect& effect : found.effects)
            if (touches(figure, nominal, effect)) d.why += (d.why.empty() ? "" : ", ") + effect_text(effect);
        if (!d.any()) continue;
        for (const int side : {0, 1}) d.on_side[side] = departure(figure, nominal, built, side);
        const std::array<double, 2> build = of_build(figure, bench, found, std::abs(d.on_side[0] - d.on_side[1]) < kNothing);
        for (const int side : {0, 1})
            if (std::abs(d.on_side[side]) > kNothing) d.on_side[side] += build[side];
    }
    press_by_radius(rest_deflection, all);
    return all;
}

std::vector<gap::Cause> not_mended(const gap::Case& bench, const gap::Diagnosis& found) {
    const BuiltRig nominal(bench.rig);
    std::vector<gap::Cause> all;
    for (const gap::FoundEffect& effect : found.effects)
        if (std::none_of(figures().begin(), figures().end(),
                         [&](const Figure& figure) { return figure.cut && touches(figure, nominal, effect); }))
            all.push_back(effect.cause);
    return all;
}

std::string instead_of_cams(const std::string& id) {
    static const std::vector<std::pair<std::string, std::string>> kAdvice{
        {"joint.coulomb", "look at the joint's bearing: alignment, preload, seals; the corrected profile has it in its model"},
        {"cable.tension_friction", "look at the joint's pulley and bearing under load; the corrected profile has it in its model"},
        {"joint.viscous", "look at the joint's grease and seals; the corrected profile has it in its model"},
        {"gear.viscous", "move slower or change the grease; the corrected profile has it in its model"},
        {"joint.stop", "find what the joint runs into and take it away"},
        {"joint.gravity", "balance the joint, or stand it so that gravity has no lever"},
        {"gear.asymmetry", "measure both directions by break-away tests: a profile knows one friction for winding in and paying out"},
        {"gear.load_quadratic", "measure the friction by break-away tests and name the table in rig.gear_friction_table"},
        {"gear.backlash", "take the play out of the gear or its coupling"},
        {"se.hysteresis", "look at the torsion spring: coils that rub, a leg that slips"},
        {"pe.hysteresis", "look at the compression spring: coils or guide that rub"},
        {"pe.bottoming", "take a compression spring with more travel to solid (k_pe.spring.max_travel_mm)"},
        {"motor.saturation", "command less torque, or take a stronger motor"},
        {"loop.delay", "look at the controller: no spring changes it"},
        {"sensor.torque_scale", "calibrate the motor's torque; do not cut cams for it"},
        {"sensor.joint_offset", "set the joint encoder's zero"},
    };
    const auto known = std::find_if(kAdvice.begin(), kAdvice.end(), [&](const auto& row) { return row.first == id; });
    return known != kAdvice.end() ? known->second : "no figure of a profile stands for it";
}

double as_built(const profile::Profile& profile, const Figure& figure, double departure) {
    const double was = profile::number_of(profile, figure.key);
    return figure.relative ? was * (1.0 + departure) : was + departure;
}

}  // namespace fusee::redesign
