#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace fusee::random_profiles {

/// SplitMix64: the standard library's distributions differ between machines.
class Dice {
public:
    Dice(std::uint64_t seed, int number) : state_(seed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(number)) {}

    double between(double low, double high) { return low + (high - low) * static_cast<double>(next() >> 11U) * 0x1.0p-53; }
    bool chance(double share) { return between(0.0, 1.0) < share; }
    template <class T, std::size_t N>
    T one_of(const std::array<T, N>& values) {
        return values[std::min(N - 1, static_cast<std::size_t>(between(0.0, static_cast<double>(N))))];
    }

private:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31U);
    }
    std::uint64_t state_;
};

}  // namespace fusee::random_profiles
