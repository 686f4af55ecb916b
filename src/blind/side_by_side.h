#pragma once
#include <cstddef>
#include <mutex>

#include "fusee/core/parallel.h"

namespace fusee::blind {

/// core::parallel_for over `items`, with a call of `finished(number of items done, item)` after each; these calls do not overlap.
template <class Work, class Finished>
void side_by_side(std::size_t items, unsigned jobs, const Work& work, const Finished& finished) {
    std::mutex mutex;
    std::size_t done = 0;
    core::parallel_for(items, jobs, [&](std::size_t i) {
        work(i);
        const std::lock_guard lock(mutex);
        finished(++done, i);
    });
}

}  // namespace fusee::blind
