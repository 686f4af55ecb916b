#pragma once
#include <memory>

#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

/// The two sides of an antagonistic joint: a part and its mirror image (docs/theory/cams.md).
struct Pair {
    std::shared_ptr<const DesignedPart> agonist;
    std::shared_ptr<const DesignedPart> antagonist;  ///< null: none; its findings are empty: they are those of the agonist
};

/// @param both false: no antagonist
[[nodiscard]] Pair pair_of(DesignedPart agonist, bool both);

/// The antagonist's spring: a coil of the other hand, with the same figures.
[[nodiscard]] spring::BaseSpring mirrored(spring::BaseSpring spring);

}  // namespace fusee::pipeline
