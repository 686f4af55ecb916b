#pragma once
#include <cstddef>
#include <functional>

namespace fusee::core {

/// More threads than any machine has use for.
inline constexpr unsigned kMostWorkers = 1024;

/// How many threads `jobs` asks for (0: one for each processor): at most one for each item and kMostWorkers, at least 1.
[[nodiscard]] unsigned worker_count(unsigned jobs, std::size_t items);

/// Runs `work` on this thread and on `count` - 1 others, and waits for all. Where the system gives no more threads, fewer run it: work is
/// to be taken from a common counter. @pre `work` does not throw
void run_workers(unsigned count, const std::function<void()>& work);

}  // namespace fusee::core
