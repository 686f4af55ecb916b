#include "fusee/core/azimuth_bins.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"

namespace fusee::core {

namespace {

constexpr std::size_t kBins = 1024;

std::size_t bin_of(double azimuth) {
    const double share = azimuth / kTurn - std::floor(azimuth / kTurn);
    return std::min(kBins - 1, static_cast<std::size_t>(share * kBins));
}

}  // namespace

AzimuthBins::AzimuthBins() : bins_(kBins) {}

void AzimuthBins::add(std::uint32_t item, std::span<const std::array<double, 2>> hull) {
    // Azimuths relative to the first point's; a hull with the axis inside or on it spans half a turn or more.
    const double base = std::atan2(hull.front()[1], hull.front()[0]);
    double begin = 0.0, end = 0.0;
    bool all = false;
    for (const auto& [x, y] : hull) {
        const double at = std::remainder(std::atan2(y, x) - base, kTurn);
        begin = std::min(begin, at);
        end = std::max(end, at);
        all = all || (x == 0.0 && y == 0.0);
    }
    all = all || end - begin >= kTurn / 2.0 - 1e-9;
    // One more bin on both sides: the ray's own azimuth is rounded too.
    const std::size_t first = all ? 0 : (bin_of(base + begin) + kBins - 1) % kBins;
    const std::size_t count = all ? kBins : std::min(kBins, static_cast<std::size_t>((end - begin) / kTurn * kBins) + 4);
    for (std::size_t i = 0; i < count; ++i) bins_[(first + i) % kBins].push_back(item);
}

const std::vector<std::uint32_t>& AzimuthBins::at(double azimuth) const { return bins_[bin_of(azimuth)]; }

}  // namespace fusee::core
