#pragma once
#include <cstdint>

namespace fusee::plant {

/// Counter-based random numbers: a stream depends on (seed, index, purpose) and the number of draws, not on threads.
/// Each number is a hash of key and counter (the finaliser of SplitMix64, Steele, Lea & Flood 2014).
class Random {
public:
    Random(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose);

    [[nodiscard]] std::uint64_t bits();
    [[nodiscard]] double uniform(double low, double high);
    [[nodiscard]] double normal();                         ///< standard normal (Box & Muller)
    [[nodiscard]] double either_sign(double magnitude);    ///< +magnitude or -magnitude at even odds
    [[nodiscard]] std::uint64_t below(std::uint64_t end);  ///< 0 .. end - 1. @pre end > 0 and far below 2^64

private:
    std::uint64_t key_, counter_ = 0;
};

}  // namespace fusee::plant
