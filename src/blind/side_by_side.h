#pragma once
#include <cstddef>
#include <functional>

namespace fusee::blind {

/// Does work(0), ... work(items - 1) on several threads, each item once. After each, `finished(how many are done, item)` is called; these
/// calls do not overlap. The first exception of either ends it when the items in hand are done, and is thrown on.
/// @param jobs threads; 0: as many as cores
void side_by_side(std::size_t items, unsigned jobs, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t done, std::size_t item)>& finished);

}  // namespace fusee::blind
