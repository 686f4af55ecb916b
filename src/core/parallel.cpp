#include "fusee/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define FUSEE_TSAN
#endif
#endif
#ifndef FUSEE_TSAN
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace fusee::core {

namespace {

/// At most `wanted`: the number of threads, this one included, that the system allows at the same time. oneTBB ends the program if it
/// cannot start a thread, so they are tested first. Where the limit is reached, half of it stays free: the threads also need memory.
unsigned available_threads(unsigned wanted) {
    static std::atomic<unsigned> known{1};
    if (wanted <= known) return wanted;
    std::promise<void> over;
    const std::shared_future<void> end = over.get_future().share();
    std::vector<std::thread> probes;
    std::size_t usable = wanted - 1;
    try {
        while (probes.size() < usable) {
            probes.emplace_back([end] {
                void* volatile first = std::malloc(64);  // the first allocation of a thread reserves address space for all later ones
                end.wait();
                std::free(first);
            });
        }
    } catch (const std::exception&) {  // std::system_error or std::bad_alloc: the limit is reached
        usable = probes.size() / 2;
    }
    over.set_value();
    for (std::thread& probe : probes) probe.join();
    const auto available = static_cast<unsigned>(usable) + 1;
    known = std::max(known.load(), available);
    return available;
}

#ifdef FUSEE_TSAN
// Debian's oneTBB is not instrumented, so that the thread sanitizer would report its hand-over of tasks. Plain threads take its place
// there.

/// Calls `work` alone: the loops in it have their own threads.
template <class Work>
void in_arena(unsigned, const Work& work) {
    work();
}

/// `body` for 0 .. count - 1 on `threads` threads, this one included. Throws what a body threw first; the others then end early.
void loop(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::once_flag failed;
    const auto take = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) body(i);
        } catch (...) {
            next = count;
            std::call_once(failed, [&] { failure = std::current_exception(); });
        }
    };
    std::vector<std::jthread> others(threads - 1);
    for (std::jthread& other : others) other = std::jthread(take);
    take();
    others.clear();  // joins them
    if (failure) std::rethrow_exception(failure);
}
#else
template <class Work>
void in_arena(unsigned threads, const Work& work) {
    // oneTBB allows as many threads as processors; of several limits the least holds, so a small loop must not set one for the loop around
    // it.
    std::optional<tbb::global_control> allowed;
    if (threads > static_cast<unsigned>(tbb::info::default_concurrency()))
        allowed.emplace(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena(static_cast<int>(threads)).execute(work);
}

void loop(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& body) {
    in_arena(threads, [&] { tbb::parallel_for(std::size_t{0}, count, body, tbb::simple_partitioner()); });
}
#endif

}  // namespace

unsigned worker_count(unsigned jobs, std::size_t items) {
    const unsigned wanted = jobs > 0 ? jobs : std::max(1U, std::thread::hardware_concurrency());
    return static_cast<unsigned>(std::clamp<std::size_t>(items, 1, std::min(wanted, kMostWorkers)));
}

void parallel_for(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& body) {
    const unsigned threads = available_threads(worker_count(jobs, count));
    if (threads == 1) {
        for (std::size_t i = 0; i < count; ++i) body(i);
        return;
    }
    loop(count, threads, body);
}

void with_threads(unsigned jobs, const std::function<void()>& work) { in_arena(available_threads(worker_count(jobs, kMostWorkers)), work); }

}  // namespace fusee::core
