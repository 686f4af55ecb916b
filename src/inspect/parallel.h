#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>

#include "fusee/core/workers.h"

namespace fusee::inspect {

/// work(0) .. work(count - 1) on `jobs` threads (0: one for each processor); each writes its own place only, so that the result does not
/// depend on their number. @pre work does not throw
template <class Work>
void each(std::size_t count, unsigned jobs, const Work& work) {
    constexpr std::size_t kAtOnce = 64;
    std::atomic<std::size_t> next{0};
    const auto worker = [&] {
        for (std::size_t i = next.fetch_add(kAtOnce); i < count; i = next.fetch_add(kAtOnce))
            for (std::size_t k = i; k < std::min(i + kAtOnce, count); ++k) work(k);
    };
    core::run_workers(core::worker_count(jobs, (count + kAtOnce - 1) / kAtOnce), worker);
}

}  // namespace fusee::inspect
