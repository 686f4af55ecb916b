#pragma once
#include <future>
#include <span>
#include <vector>

#include "fusee/cam/arm.h"

namespace fusee::pipeline {

/// The parts share only the resolved design: each is worked on its own thread. @return the results in the order of `kinds`
template <class Work>
auto each_part(std::span<const cam::PartKind> kinds, const Work& work) {
    using Result = decltype(work(kinds.front()));
    std::vector<std::future<Result>> begun;
    for (const cam::PartKind kind : kinds.first(kinds.size() - 1))
        begun.push_back(std::async(std::launch::async | std::launch::deferred, [&work, kind] { return work(kind); }));
    Result last = work(kinds.back());
    std::vector<Result> results;
    for (std::future<Result>& one : begun) results.push_back(one.get());
    results.push_back(std::move(last));
    return results;
}

}  // namespace fusee::pipeline
