#pragma once
#include <future>
#include <vector>

namespace fusee::pipeline {

/// The parts share only the resolved design: each is worked on its own thread. @param parts one thing a part @return in their order
template <class Part, class Work>
auto each_part(const std::vector<Part>& parts, const Work& work) {
    using Result = decltype(work(parts.front()));
    std::vector<std::future<Result>> begun;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i)
        begun.push_back(std::async(std::launch::async | std::launch::deferred, [&work, &part = parts[i]] { return work(part); }));
    Result last = work(parts.back());
    std::vector<Result> results;
    for (std::future<Result>& one : begun) results.push_back(one.get());
    results.push_back(std::move(last));
    return results;
}

}  // namespace fusee::pipeline
