#include "figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/lists.h"
#include "fusee/effects/effect.h"
#include "fusee/profile/edit.h"
#include "fusee/search/redesign.h"

namespace fusee::search::redesign {

namespace {

using joint_model::BuiltRig;
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

void put(const diagnosis::FoundEffect& found, BuiltRig& rig) {
    const effects::Effect& effect = effects::find_effect(found.cause.id);
    std::vector<double> values{found.parameter.value};
    for (std::size_t i = 1; i < effect.parameters.size(); ++i) {
        const auto given = std::find_if(found.extra.begin(), found.extra.end(),
                                        [&](const auto& named) { return named.first == effect.parameters[i].name; });
        values.push_back(given != found.extra.end() ? given->second : effects::on_rig(effect.parameters[i], rig.reference).at_first);
    }
    effects::apply_effect(effect, found.cause, values, rig);
}

double departure(const Figure& figure, const BuiltRig& nominal, const BuiltRig& built, int side) {
    const double was = figure.value(nominal, side), change = figure.value(built, side) - was;
    if (!figure.relative) return change;
    return was == 0.0 ? 0.0 : change / was;
}

bool touches(const Figure& figure, const BuiltRig& nominal, const diagnosis::FoundEffect& found) {
    BuiltRig alone = nominal;
    put(found, alone);
    return std::max(std::abs(departure(figure, nominal, alone, 0)), std::abs(departure(figure, nominal, alone, 1))) > kNothing;
}

/// "gear.load_friction on both sides 0.3 (95 %: 0.28 to 0.32)"
std::string effect_text(const diagnosis::FoundEffect& found) {
    const std::string side = found.cause.side == "none"   ? ""
                             : found.cause.side == "both" ? " on both sides"
                                                          : " on the " + found.cause.side;
    const std::string unit = found.parameter.unit.empty() || found.parameter.unit == "1" ? "" : " " + found.parameter.unit;
    const core::Range& ci = found.parameter.ci95;
    const std::string interval = std::isfinite(ci.low + ci.high) ? fmt::format(" (95 %: {:.4g} to {:.4g})", ci.low, ci.high) : "";
    return fmt::format("{}{} {:.4g}{}{}", found.cause.id, side, found.parameter.value, unit, interval);
}

/// Departures by the fitted build of the rig, each side. Friction is given in mu, not relative.
std::array<double, 2> of_build(const Figure& figure, const gap_case::Case& gap_case, const diagnosis::Diagnosis& found,
                               bool equal_on_both) {
    std::array<double, 2> all{};
    if (figure.build.empty()) return all;
    for (const int side : {0, 1})
        for (const auto& [name, parameter] : found.build)
            if (name == figure.build + " " + to_string(static_cast<gap_case::Side>(side))) all[side] = parameter.value;
    if (equal_on_both) all.fill(0.5 * (all[0] + all[1]));
    const double mu = gap_case.rig.gear_load_friction;
    if (figure.of == Of::kGear)
        for (double& value : all) value = mu > 0.0 ? value / mu : 0.0;
    return all;
}

/// K_PE's share of a longer arm below the profile's stop.
void press_by_radius(double rest_deflection, std::vector<Departure>& all) {
    const auto of = [&all](const char* key) -> Departure& {
        return all[static_cast<std::size_t>(core::find_by(figures(), &Figure::key, std::string_view(key)) - figures().data())];
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

std::vector<Departure> departures(const gap_case::Case& gap_case, const diagnosis::Diagnosis& found, double rest_deflection) {
    const BuiltRig nominal(gap_case.rig);
    BuiltRig built = nominal;
    for (const diagnosis::FoundEffect& effect : found.effects) put(effect, built);
    std::vector<Departure> all;
    for (const Figure& figure : figures()) {
        Departure& d = all.emplace_back();
        for (const diagnosis::FoundEffect& effect : found.effects)
            if (touches(figure, nominal, effect)) d.why += (d.why.empty() ? "" : ", ") + effect_text(effect);
        if (!d.any()) continue;
        for (const int side : {0, 1}) d.on_side[side] = departure(figure, nominal, built, side);
        const std::array<double, 2> build = of_build(figure, gap_case, found, std::abs(d.on_side[0] - d.on_side[1]) < kNothing);
        for (const int side : {0, 1})
            if (std::abs(d.on_side[side]) > kNothing) d.on_side[side] += build[side];
    }
    press_by_radius(rest_deflection, all);
    return all;
}

std::vector<effects::Cause> not_mended(const gap_case::Case& gap_case, const diagnosis::Diagnosis& found) {
    const BuiltRig nominal(gap_case.rig);
    std::vector<effects::Cause> all;
    for (const diagnosis::FoundEffect& effect : found.effects)
        if (std::none_of(figures().begin(), figures().end(),
                         [&](const Figure& figure) { return figure.cut && touches(figure, nominal, effect); }))
            all.push_back(effect.cause);
    return all;
}

std::vector<std::string> keys_of_effect(const std::string& effect_id) {
    const effects::Effect& effect = effects::find_effect(effect_id);
    gap_case::NominalRig rig;
    rig.gear_load_friction = 0.1;  // a relative departure needs some
    const BuiltRig nominal(rig);
    diagnosis::FoundEffect found;
    found.cause = {effect.id, effect.sided ? "both" : "none"};
    found.parameter.value = effect.parameters.front().scale;
    std::vector<std::string> keys;
    for (const Figure& figure : figures())
        if (touches(figure, nominal, found)) keys.push_back(figure.key);
    return keys;
}

std::string instead_of_cams(const std::string& id) { return effects::find_effect(id).advice; }

double as_built(const profile::Profile& profile, const Figure& figure, double departure) {
    const double was = profile::number_of(profile, figure.key);
    return figure.relative ? was * (1.0 + departure) : was + departure;
}

}  // namespace fusee::search::redesign
