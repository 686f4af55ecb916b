#pragma once
#include <vector>

#include "fusee/effects/effect.h"

namespace fusee::effects {

/// A figure of [rig] in case.toml is not what was stated, by a share of what was stated. Figures of springs, gear friction, preloads and
/// zeros have effects of the same law in library.cpp.
[[nodiscard]] std::vector<Effect> figure_effects();

}  // namespace fusee::effects
