#pragma once
#include <cmath>
#include <cstdint>

#include "fusee/core/units.h"

namespace fusee::math {

/// Random numbers by counting: draw `i` of a stream is a hash of (seed, generation, individual, i), independent of the order of
/// draws. The hash is the finaliser of SplitMix64 (Steele, Lea & Flood 2014), applied once for each number of the key.
class Stream {
public:
    Stream(std::uint64_t seed, std::uint64_t generation, std::uint64_t individual)
        : key_(mixed(mixed(mixed(seed), generation), individual)) {}

    /// Uniform in [0, 1).
    [[nodiscard]] double uniform(std::uint64_t draw) const { return static_cast<double>(mixed(key_, draw) >> 11) * 0x1p-53; }
    /// Standard normal, from the draws `draw` and `draw` + 1: Box and Muller (1958).
    [[nodiscard]] double normal(std::uint64_t draw) const {
        return std::sqrt(-2.0 * std::log1p(-uniform(draw))) * std::cos(2.0 * core::kPi * uniform(draw + 1));
    }
    /// Uniform in 0 .. count - 1.
    [[nodiscard]] int index(std::uint64_t draw, int count) const { return static_cast<int>(uniform(draw) * count); }

private:
    [[nodiscard]] static std::uint64_t mixed(std::uint64_t state, std::uint64_t value = 0) {
        std::uint64_t z = state + (value + 1) * 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    std::uint64_t key_;
};

}  // namespace fusee::math
