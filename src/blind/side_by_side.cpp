#include "side_by_side.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

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
    const unsigned wanted = jobs != 0 ? jobs : std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::thread> threads;
    try {
        for (std::size_t i = 1; i < std::min<std::size_t>(wanted, items); ++i) threads.emplace_back(run);
    } catch (const std::system_error&) {  // the system gives no more threads: those that there are do the work
    }
    run();
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace fusee::blind
