#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/joint_model/built_rig.h"

namespace fusee::effects {

using gap_case::Experiment;
using joint_model::BuiltRig;

/// An effect on a side: "gear.coulomb" on "agonist", "antagonist" or "both"; "none" for those that have no side.
struct Cause {
    std::string id, side = "none";
    [[nodiscard]] bool operator==(const Cause&) const = default;
};

/// A figure of an effect's law.
struct EffectParameter {
    std::string name, unit;
    double scale = 1.0;              ///< what is usual: one sigma of the prior, in `unit`
    core::Range allowed;             ///< hard limits
    double at_first = 0.0;           ///< further parameters start here
    std::vector<double> tries = {};  ///< and are tried here, in `unit`, before a fit; empty: at_first alone
};

/// One thing that a rig may do and its nominal model does not. Each stands in a file of its own under src/effects, which registers it
/// by being there (docs/guides/add-an-effect.md).
struct Effect {
    std::string id;
    std::string law;                                              ///< one sentence with its symbols
    std::string meaning;                                          ///< what it is on a rig, with what its sign says, in a sentence
    bool sided = false;                                           ///< on the agonist's, the antagonist's or both sides
    std::vector<EffectParameter> parameters;                      ///< the first is its size: 0 is no effect
    std::vector<double> starts;                                   ///< sizes to try first, in units of the first parameter's scale
    std::vector<Experiment> seen_by;                              ///< experiments that it changes
    std::vector<std::string> confused_with;                       ///< ids with a like signature in some experiments, for the reader
    std::string advice = "no figure of a profile stands for it";  ///< what to do where new cams do not help
    /// Puts it on one side of the rig (side 0 for an effect without sides). `values` as `parameters`.
    void (*apply)(BuiltRig& rig, int side, std::span<const double> values) = nullptr;

    /// Its size is where something begins (a stop's angle), which has no size of 0.
    [[nodiscard]] bool is_limit() const { return parameters.front().allowed.low > 0.0; }
};

/// All of them, by id.
[[nodiscard]] const std::vector<Effect>& effect_library();
/// Null where there is none of this id.
[[nodiscard]] const Effect* effect_or_none(std::string_view id);
/// @throws core::InvalidInput with the ids that there are
[[nodiscard]] const Effect& find_effect(const std::string& id);
/// On the sides that `cause` names: "agonist", "antagonist", "both", or "none" for an effect that has no side.
/// @throws core::InvalidInput naming a side that the effect does not have
void apply_effect(const Effect& effect, const Cause& cause, std::span<const double> values, BuiltRig& rig);

}  // namespace fusee::effects
