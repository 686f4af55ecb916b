#pragma once
#include "gaps.h"

namespace fusee::assembly {

/// Proves a distance of two bodies over every pose of the working range, not only at samples. The range is cut into boxes; in each, a body
/// that slides is taken as the hull of all its places, one that turns as the disc around it, or, where it turns by little, in its middle
/// pose with its distance less the way of its farthest point. Boxes whose bound is below the aim are halved. `gap` holds the sampled least
/// distance on entry; its distance and pose are lowered where a middle pose is nearer, and `proven_mm` is set.
/// @param enough_mm proofs beyond it are not sought
void prove(const Assembly& assembly, const Body& one, const Body& other, double enough_mm, Gap& gap);

/// The bound of the whole range as one box, or `most_mm` if it is that much or more.
[[nodiscard]] double bound_mm(const Assembly& assembly, const Body& one, const Body& other, double most_mm);

}  // namespace fusee::assembly
