#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "fusee/toolpath/read_back.h"

namespace fusee::toolpath {

/// A sphere swept straight from a to b, in the part's body frame [mm]; in a plane, a disc.
struct Capsule {
    std::array<double, 3> a{}, b{};
    double radius = 0.0;
};

/// Interval of a ray inside a swept volume, as distances from the axis.
struct SweptInterval {
    double low = 0.0, high = 0.0;
};

/// The interval of the line (t cos azimuth, t sin azimuth, z) inside the capsule: a single one, since a capsule is convex.
[[nodiscard]] std::optional<SweptInterval> interval_in(const Capsule& capsule, double azimuth, double z);

/// The volume that a cutter's end removed, sorted by azimuth.
class CutFloor::Swept {
public:
    explicit Swept(const std::vector<Capsule>& capsules);
    [[nodiscard]] std::optional<double> floor(double azimuth, double z) const;

private:
    struct Near {
        Capsule capsule;
        double least = 0.0;  ///< least distance from the axis [mm]; below 0: it may contain the axis
        std::array<double, 3> middle{};
        double reach = 0.0;  ///< radius of the sphere about the middle that holds it [mm]
    };
    void put(std::uint32_t i);

    std::vector<Near> near_;                        ///< nearest first
    std::vector<std::vector<std::uint32_t>> bins_;  ///< by azimuth: numbers of near_, ascending
};

}  // namespace fusee::toolpath
