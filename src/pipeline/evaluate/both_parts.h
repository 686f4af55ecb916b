#pragma once
#include <future>
#include <utility>

#include "fusee/cam/arm.h"

namespace fusee::pipeline {

/// The two parts share only the resolved design: each is worked on its own thread. @return the results for K_SE and K_PE
template <class Work>
auto both_parts(const Work& work) {
    auto series = std::async(std::launch::async | std::launch::deferred, [&] { return work(cam::PartKind::kSeries); });
    auto parallel = work(cam::PartKind::kParallel);
    return std::pair{series.get(), std::move(parallel)};
}

}  // namespace fusee::pipeline
