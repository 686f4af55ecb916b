#pragma once
#include <cstddef>
#include <functional>

namespace fusee::core {

/// The largest number of threads that a caller can request.
inline constexpr unsigned kMostWorkers = 1024;

/// Number of threads for `jobs` (0: one per processor): at most one per item and kMostWorkers, at least 1.
[[nodiscard]] unsigned worker_count(unsigned jobs, std::size_t items);

/// Calls body(0) .. body(count - 1) on worker_count(jobs, count) threads of oneTBB, or on fewer if the system has no more. Each call must
/// write to its own place, so that the result is the same for any number of threads. With one thread the calls are in order.
/// @throws what a call throws; the calls that have not begun are skipped
void parallel_for(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& body);

/// Calls `work` so that a library's oneTBB loops inside it run on as many threads as parallel_for would use for many items.
void with_threads(unsigned jobs, const std::function<void()>& work);

}  // namespace fusee::core
