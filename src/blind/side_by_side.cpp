#include "side_by_side.h"

#include <atomic>
#include <exception>
#include <mutex>

#include "fusee/core/workers.h"

namespace fusee::blind {

void side_by_side(std::size_t items, unsigned jobs, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t, std::size_t)>& finished) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;
    std::size_t done = 0;
    std::exception_ptr failure;
    const auto run = [&] {
        for (std::size_t i = next++; i < items && !failed; i = next++) try {
                work(i);
                const std::lock_guard lock(mutex);
                if (!failed) finished(++done, i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!failure) failure = std::current_exception();
                failed = true;
            }
    };
    core::run_workers(core::worker_count(jobs, items), run);
    if (failure) std::rethrow_exception(failure);
}

}  // namespace fusee::blind
