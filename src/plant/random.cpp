#include <cmath>

#include "fusee/core/units.h"
#include "fusee/plant/rig.h"

namespace fusee::plant {

namespace {

constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;

std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose)
    : key_(mixed(mixed(mixed(seed + kGolden) + index * kGolden + 1) + purpose * kGolden + 2)) {}

std::uint64_t Random::bits() { return mixed(key_ + ++counter_ * kGolden); }

double Random::uniform(double low, double high) {
    constexpr double kStep = 0x1.0p-53;
    return low + (high - low) * (static_cast<double>(bits() >> 11) + 0.5) * kStep;
}

double Random::normal() {
    const double radius = std::sqrt(-2.0 * std::log(uniform(0.0, 1.0)));
    return radius * std::cos(2.0 * core::kPi * uniform(0.0, 1.0));
}

double Random::either_sign(double magnitude) { return (bits() >> 63) != 0 ? magnitude : -magnitude; }

std::uint64_t Random::below(std::uint64_t end) { return bits() % end; }

}  // namespace fusee::plant
