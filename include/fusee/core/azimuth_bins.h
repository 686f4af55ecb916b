#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fusee::core {

/// Items sorted by the azimuths that they may cover, for the search along horizontal rays from the z axis.
class AzimuthBins {
public:
    AzimuthBins();
    /// Adds an item within the convex hull of points (x, y). A hull that contains the axis or covers half a turn belongs to every azimuth.
    void add(std::uint32_t item, std::span<const std::array<double, 2>> hull);
    /// The items that a ray at this azimuth [rad] may meet, in the order of `add`: those it meets, and some beside it.
    [[nodiscard]] const std::vector<std::uint32_t>& at(double azimuth) const;

private:
    std::vector<std::vector<std::uint32_t>> bins_;
};

}  // namespace fusee::core
