#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/inference/model.h"
#include "fusee/joint_model/built_rig.h"

namespace fusee::effects {

using gap_case::Experiment;
using joint_model::BuiltRig;

using inference::Cause;            ///< sides: "agonist", "antagonist" or "both"; "none" for effects without sides
using inference::EffectParameter;  ///< on the reference rig (gap_case::Reference)

/// Experiments that see an effect on a spring or its cable.
inline std::vector<Experiment> spring_experiments() {
    return {Experiment::kSpringPull, Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog};
}

/// A parameter of the library on a rig with this reference.
[[nodiscard]] EffectParameter on_rig(EffectParameter parameter, const gap_case::Reference& reference);

/// A possible cause of a gap: behaviour of the rig that the nominal model lacks. Each effect is one function in src/effects/library.cpp
/// (docs/guides/add-an-effect.md).
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
    bool figure = false;                                    ///< a figure of case.toml is not what was stated
    /// Applies it to one side of the rig (side 0 for an effect without sides). `values`: one for each parameter.
    void (*apply)(BuiltRig& rig, int side, std::span<const double> values) = nullptr;
};

/// All of them, by id.
[[nodiscard]] const std::vector<Effect>& effect_library();
/// The same with the parameters of a rig.
[[nodiscard]] std::vector<Effect> effects_on(const gap_case::Reference& reference);
/// Null if the id is unknown.
[[nodiscard]] const Effect* effect_or_none(std::string_view id);
/// @throws core::InvalidInput listing the known ids
[[nodiscard]] const Effect& find_effect(const std::string& id);
/// Puts the effect on the sides of the rig that `cause` names: "agonist", "antagonist", "both", or "none" for an effect that has no side.
/// @throws core::InvalidInput naming a side that the effect does not have
void apply_effect(const Effect& effect, const Cause& cause, std::span<const double> values, BuiltRig& rig);

}  // namespace fusee::effects
