#pragma once
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#include "fusee/core/workers.h"

namespace fusee::gap {

/// body(0) .. body(count - 1) on `jobs` threads; each writes its own place only, so that the result is the same for any number.
template <typename Body>
void parallel_for(std::size_t count, unsigned jobs, const Body& body) {
    tbb::task_arena arena(jobs == 0 ? tbb::task_arena::automatic : static_cast<int>(std::min(jobs, core::kMostWorkers)));
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, body, tbb::simple_partitioner()); });
}

}  // namespace fusee::gap
