#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "fusee/toolpath/read_back.h"

namespace fusee::toolpath {

/// A sphere that moved straight from a to b, in the part's body frame [mm]; in a plane, a disc.
struct Capsule {
    std::array<double, 3> a{}, b{};
    double radius = 0.0;
};

/// Part of a ray that lies in something, distances from the axis.
struct SweptInterval {
    double low = 0.0, high = 0.0;
};

/// The part of the line (t cos azimuth, t sin azimuth, z) that lies in the capsule: one stretch, since a capsule is convex.
[[nodiscard]] std::optional<SweptInterval> interval_in(const Capsule& capsule, double azimuth, double z);

/// All that a cutter's end took away, sorted by azimuth.
class CutFloor::Swept {
public:
    explicit Swept(std::vector<Capsule> capsules);
    [[nodiscard]] std::optional<double> floor(double azimuth, double z) const;

private:
    struct Near {
        Capsule capsule;
        double least = 0.0;  ///< it is no nearer to the axis [mm]; below 0: it may hold the axis
        double azimuth = 0.0, reach = 0.0;
    };
    void put(std::uint32_t i);

    std::vector<Near> near_;                        ///< nearest first
    std::vector<std::vector<std::uint32_t>> bins_;  ///< by azimuth: numbers of near_, ascending
};

}  // namespace fusee::toolpath
