#include "fusee/core/workers.h"

#include <algorithm>
#include <system_error>
#include <thread>
#include <vector>

namespace fusee::core {

unsigned worker_count(unsigned jobs, std::size_t items) {
    const unsigned wanted = jobs > 0 ? jobs : std::max(1U, std::thread::hardware_concurrency());
    return static_cast<unsigned>(std::clamp<std::size_t>(items, 1, std::min(wanted, kMostWorkers)));
}

void run_workers(unsigned count, const std::function<void()>& work) {
    std::vector<std::jthread> others;
    try {
        for (unsigned i = 1; i < count; ++i) others.emplace_back(work);
    } catch (const std::system_error&) {  // no more threads: this one does what is left
    }
    work();
}

}  // namespace fusee::core
