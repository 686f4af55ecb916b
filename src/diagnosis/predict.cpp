#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/effects/term.h"
#include "fusee/joint_model/build_parameters.h"
#include "fusee/joint_model/signals.h"
#include "workload.h"

namespace fusee::diagnosis {

namespace {

/// Parameter values of an effect: its size, and further ones as found or at their start.
std::vector<double> values_of(const effects::Effect& effect, const FoundEffect& found, const gap_case::Reference& reference) {
    std::vector<double> values{found.parameter.value};
    for (std::size_t k = 1; k < effect.parameters.size(); ++k) {
        const effects::EffectParameter& law = effect.parameters[k];
        const auto known = std::find_if(found.extra.begin(), found.extra.end(), [&](const auto& extra) { return extra.first == law.name; });
        values.push_back(known == found.extra.end() ? effects::on_rig(law, reference).at_first : known->second);
    }
    return values;
}

joint_model::BuiltRig rig_of(const gap_case::Case& nominal, const Diagnosis& found) {
    joint_model::BuiltRig rig(nominal.rig);
    for (const joint_model::BuildParameter& build : joint_model::build_parameters(nominal)) {
        const auto known =
            std::find_if(found.build.begin(), found.build.end(), [&](const auto& entry) { return entry.first == build.name; });
        build.add(rig, known == found.build.end() ? 0.0 : known->second.value);
    }
    const auto add = [&](const FoundEffect& effect) {
        const effects::Effect& law = effects::find_effect_or_term(effect.cause.id);
        effects::apply_effect(law, effect.cause, values_of(law, effect, rig.reference), rig);
    };
    for (const FoundEffect& effect : found.effects) add(effect);
    for (const UnknownTerm& term : found.unknown_terms) add(term.found);
    return rig;
}

constexpr double kMostArm = 0.1;        // of the reference rig [m]
constexpr double kSizeRounding = 1e-9;  // of a size written at a bound of its range

void require_allowed(const std::string& what, const effects::EffectParameter& law, double value) {
    const double slack = kSizeRounding * law.allowed.width();
    if (!(value >= law.allowed.low - slack && value <= law.allowed.high + slack))
        throw core::InvalidInput(what, fmt::format("{:g}", value),
                                 fmt::format("{:g} to {:g}{}", law.allowed.low, law.allowed.high, law.unit == "1" ? "" : " " + law.unit));
}

/// Checks one effect with its further parameters.
void require_possible(const std::string& place, const FoundEffect& found, const gap_case::Reference& reference) {
    const effects::Effect& law = effects::find_effect_or_term(found.cause.id);
    const effects::EffectParameter size = effects::on_rig(law.parameters.front(), reference);
    const std::string name = place + ": " + found.cause.id;
    require_allowed(name, size, found.parameter.value);
    if (const std::string& unit = found.parameter.unit; !unit.empty() && unit != size.unit)
        throw core::InvalidInput(name + ": unit", unit, size.unit);
    for (const auto& [extra, value] : found.extra) {
        std::vector<std::string> known;
        for (std::size_t k = 1; k < law.parameters.size(); ++k) {
            known.push_back(law.parameters[k].name);
            if (extra == known.back()) require_allowed(name + ": " + extra, effects::on_rig(law.parameters[k], reference), value);
        }
        if (std::find(known.begin(), known.end(), extra) == known.end())
            throw core::InvalidInput(name + ": extra", extra,
                                     known.empty() ? "no further parameters" : fmt::format("{}", fmt::join(known, ", ")));
    }
}

/// Rejects a rig that cannot be built, whatever the effect or build parameter behind it.
void require_buildable(const joint_model::BuiltRig& rig, const joint_model::NominalCams& cams) {
    const std::string whole = "the rig with these effects: ";
    std::string part;  // whose figure it is
    const auto require = [&part](bool holds, const char* what, double value, const std::string& allowed) {
        if (!holds || !std::isfinite(value)) throw core::InvalidInput(part + what, fmt::format("{:g}", value), allowed);
    };
    for (const gap_case::Side name : {gap_case::Side::kAgonist, gap_case::Side::kAntagonist}) {
        const joint_model::BuiltSide& side = rig.sides[static_cast<std::size_t>(name)];
        part = fmt::format("{}{}: ", whole, to_string(name));
        require(side.ratio > 0.0, "joint radius over capstan radius", side.ratio, "above 0");
        require(side.capstan_scale > 0.0, "capstan radius over the nominal one", side.capstan_scale, "above 0");
        require(side.motor_inertia > 0.0, "motor inertia [kg m^2]", side.motor_inertia, "above 0");
        require(side.gear.load_friction >= 0.0, "gear friction over load", side.gear.load_friction, "at least 0");
        require(side.gear.coulomb >= 0.0, "gear friction [Nm]", side.gear.coulomb, "at least 0");
        require(std::abs(side.gear.asymmetry) <= 1.0, "asymmetry of the gear friction", side.gear.asymmetry, "-1 to 1");
        require(side.gear.torque_scale > -1.0, "torque scale", side.gear.torque_scale, "above -1");
        require(side.se_build.rate > -1.0, "relative change of K_SE's rate", side.se_build.rate, "above -1");
        require(side.pe_build.rate > -1.0, "relative change of K_PE's rate", side.pe_build.rate, "above -1");
        const double arm = cams.shortest_series_arm() + side.se_build.radius;
        require(arm > 0.0, "shortest arm of K_SE [m]", arm, "above 0");
        const double most = kMostArm * rig.reference.radius;
        require(std::abs(side.pe_build.radius) < most, "arms of K_PE, longer by [m]", side.pe_build.radius,
                fmt::format("within {:g}", most));
    }
    part = whole;
    require(rig.joint_inertia > 0.0, "joint inertia [kg m^2]", rig.joint_inertia, "above 0");
    require(rig.joint_coulomb >= 0.0, "joint friction [Nm]", rig.joint_coulomb, "at least 0");
    require(std::abs(rig.joint_offset) < core::kPi, "zero of the joint encoder [rad]", rig.joint_offset, "-pi to pi");
    require(rig.hand.damping > 0.0, "damping of the hand", rig.hand.damping, "above 0");
}

void require_finite(const joint_model::Signals& signals) {
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments)
        for (std::size_t i = 0; i < signals[experiment].size(); ++i)
            if (!std::isfinite(signals[experiment][i]))
                throw core::InvalidInput(fmt::format("effects or inputs: {}", to_string(experiment)),
                                         fmt::format("value {} has no finite prediction", i + 1),
                                         "smaller effects, or inputs within the motion of this rig");
}

}  // namespace

void require_possible(const gap_case::Case& nominal, const Diagnosis& found, const std::string& file) {
    std::set<std::pair<std::string, std::string>> seen;
    const gap_case::Reference reference = gap_case::reference_of(nominal.rig);
    for (std::size_t i = 0; i < found.effects.size(); ++i) {
        const FoundEffect& effect = found.effects[i];
        const std::string place = fmt::format("{}: effects[{}]", file, i);
        if (!seen.insert({effect.cause.id, effect.cause.side}).second)
            throw core::InvalidInput(place, fmt::format("{} on {} again", effect.cause.id, effect.cause.side),
                                     "each effect once on a side");
        require_possible(place, effect, reference);
    }
    for (const UnknownTerm& term : found.unknown_terms) require_possible(file + ": unknown_term", term.found, reference);
    std::vector<std::string> names;
    for (const joint_model::BuildParameter& build : joint_model::build_parameters(nominal)) names.push_back(build.name);
    for (const auto& [name, parameter] : found.build)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw core::InvalidInput(file + ": build", name, fmt::format("{}", fmt::join(names, ", ")));
}

joint_model::BuiltRig built_rig(const gap_case::Case& nominal, const Diagnosis& found) {
    joint_model::BuiltRig rig = rig_of(nominal, found);
    const joint_model::NominalCams cams(nominal.rig);
    require_buildable(rig, cams);
    rig.assemble(cams);
    return rig;
}

gap_case::Rows predict(const gap_case::Case& nominal, const Diagnosis& found, const gap_case::Rows& inputs) {
    require_feasible(nominal.rig, inputs, nominal.protocol, kMostPredicted);
    const joint_model::BuiltRig rig = built_rig(nominal, found);
    const joint_model::Signals signals = joint_model::predict_signals(rig, inputs, nominal.protocol);
    require_finite(signals);
    return joint_model::with_measured(inputs, signals);
}

}  // namespace fusee::diagnosis
