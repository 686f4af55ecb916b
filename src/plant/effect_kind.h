#pragma once
#include <vector>

#include "fusee/plant/case_files.h"
#include "fusee/plant/rig.h"

namespace fusee::plant {

/// One kind of effect: how its size is drawn and what it changes.
struct EffectKind {
    const char* id;
    void (*draw)(const RigRange& range, Random& random, Effect& effect);
    void (*to_side)(const Effect& effect, SideTruth& side);               ///< none for an effect without side
    void (*to_joint)(const Effect& effect, JointTruth& joint) = nullptr;  ///< none for one with side
};

[[nodiscard]] const std::vector<EffectKind>& library_kinds();
[[nodiscard]] const std::vector<EffectKind>& figure_kinds();
[[nodiscard]] const std::vector<EffectKind>& outside_kinds();
[[nodiscard]] const std::vector<EffectKind>& form_blind_kinds();
[[nodiscard]] const std::vector<EffectKind>& engine_kinds();

}  // namespace fusee::plant
