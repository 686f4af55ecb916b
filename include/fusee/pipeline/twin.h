#pragma once
#include "fusee/mjcf/twin.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

/// The design's joint for the simulator MuJoCo, with inertia and drag of `[dynamics]`; what the profile states beyond springs and friction
/// of gears and bearing is named as not expressed. @throws core::InvalidInput for one of the paper's relatives
[[nodiscard]] mjcf::Twin twin_of(const ResolvedDesign& design);

}  // namespace fusee::pipeline
