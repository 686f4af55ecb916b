#pragma once
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

#include "fusee/core/workers.h"

namespace fusee::gap::bench {

/// Calls work(i) for i < count on `jobs` threads (0: as many as cores). Each i writes to a place of its own: the answer is the same for any
/// number of threads. The first exception stops the rest and is thrown on.
template <class Work>
void for_each_index(std::size_t count, unsigned jobs, const Work& work) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex mutex;
    const auto run = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!failure) failure = std::current_exception();
                next = count;
            }
        }
    };
    core::run_workers(core::worker_count(jobs, count), run);
    if (failure) std::rethrow_exception(failure);
}

}  // namespace fusee::gap::bench
