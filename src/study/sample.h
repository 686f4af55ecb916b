#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "fusee/study/study.h"

namespace fusee::study {

/// Points of the unit cube [0, 1)^dimensions, each from its index alone.
class Sample {
public:
    virtual ~Sample() = default;
    [[nodiscard]] virtual std::vector<double> point(std::size_t index) const = 0;
};

/// @pre method is kRandom, kLatinHypercube or kSobol; 1 <= dimensions <= kMostSobolKeys for kSobol
[[nodiscard]] std::unique_ptr<Sample> make_sample(Method method, std::size_t dimensions, std::size_t count, std::uint64_t seed);

inline constexpr std::size_t kMostSobolKeys = 3666;  // of Boost's table of direction numbers

}  // namespace fusee::study
