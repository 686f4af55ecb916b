#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/joint_model/built_rig.h"

namespace fusee::effects {

using gap_case::Experiment;
using joint_model::BuiltRig;

/// An effect and its side: "gear.coulomb" on "agonist", "antagonist" or "both"; "none" for effects without sides.
struct Cause {
    std::string id, side = "none";
    [[nodiscard]] bool operator==(const Cause&) const = default;
};

/// Experiments that see an effect on a spring or its cable.
inline std::vector<Experiment> spring_experiments() {
    return {Experiment::kSpringPull, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog};
}

/// A parameter of an effect, on the reference rig (gap_case::Reference).
struct EffectParameter {
    std::string name, unit;
    double scale = 1.0;              ///< usual size, in `unit`: the prior is normal with 3 of it
    core::Range allowed;             ///< hard limits
    double at_first = 0.0;           ///< start value of a further parameter
    std::vector<double> tries = {};  ///< values of a further parameter to try before a fit, in `unit`; empty: only at_first

    /// On a rig with this reference.
    [[nodiscard]] EffectParameter on(const gap_case::Reference& reference) const;
};

/// A possible cause of a gap: behaviour of the rig that the nominal model lacks. Each effect is one file in src/effects, which registers
/// by its existence (docs/guides/add-an-effect.md).
struct Effect {
    std::string id;
    std::string law;                                        ///< one sentence with its symbols
    std::string meaning;                                    ///< one sentence: what it is on a rig and what its sign means
    bool sided = false;                                     ///< acts on agonist, antagonist or both
    std::vector<EffectParameter> parameters;                ///< the first is its size: 0 is no effect
    std::vector<double> starts;                             ///< sizes to try first, in scales of the first parameter
    std::vector<Experiment> seen_by;                        ///< experiments that it changes
    std::vector<std::string> confused_with;                 ///< ids with a similar signature in some experiments, for the reader
    std::string advice = "no profile value represents it";  ///< what to do where new cams do not help
    /// Applies it to one side of the rig (side 0 for an effect without sides). `values`: one for each parameter.
    void (*apply)(BuiltRig& rig, int side, std::span<const double> values) = nullptr;

    /// Its size is a limit (for example the angle of a stop), which is never 0.
    [[nodiscard]] bool is_limit() const { return parameters.front().allowed.low > 0.0; }
    /// It is a ripple: its parameters are amplitude, count and phase [rad]. The opposite amplitude is the same law half a turn on.
    [[nodiscard]] bool has_phase() const { return parameters.back().name == "phase"; }
};

/// All of them, by id.
[[nodiscard]] const std::vector<Effect>& effect_library();
/// The same with the parameters of a rig.
[[nodiscard]] std::vector<Effect> effects_on(const gap_case::Reference& reference);
/// Null if the id is unknown.
[[nodiscard]] const Effect* effect_or_none(std::string_view id);
/// @throws core::InvalidInput listing the known ids
[[nodiscard]] const Effect& find_effect(const std::string& id);
/// On the sides that `cause` names: "agonist", "antagonist", "both", or "none" for an effect that has no side.
/// @throws core::InvalidInput naming a side that the effect does not have
void apply_effect(const Effect& effect, const Cause& cause, std::span<const double> values, BuiltRig& rig);

}  // namespace fusee::effects
