#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

#include "fusee/core/workers.h"

namespace fusee::inspect {

/// work(0) .. work(count - 1) on `jobs` threads (0: one for each processor); each writes its own place only, so that the result does not
/// depend on their number. What `work` throws (memory may run out) comes out once all threads have ended.
template <class Work>
void each(std::size_t count, unsigned jobs, const Work& work) {
    constexpr std::size_t kAtOnce = 64;
    std::atomic<std::size_t> next{0};
    std::exception_ptr thrown;
    std::mutex mutex;
    const auto worker = [&] {
        try {
            for (std::size_t i = next.fetch_add(kAtOnce); i < count; i = next.fetch_add(kAtOnce))
                for (std::size_t k = i; k < std::min(i + kAtOnce, count); ++k) work(k);
        } catch (...) {
            const std::scoped_lock lock(mutex);
            thrown = std::current_exception();
            next = count;
        }
    };
    core::run_workers(core::worker_count(jobs, (count + kAtOnce - 1) / kAtOnce), worker);
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace fusee::inspect
