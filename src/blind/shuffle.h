#pragma once
#include <utility>
#include <vector>

#include "fusee/plant/rig.h"

namespace fusee::blind {

/// Uniformly random order (Fisher & Yates).
template <class T>
void shuffle(std::vector<T>& items, plant::Random& random) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
}

}  // namespace fusee::blind
