#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fusee/core/azimuth_bins.h"
#include "fusee/exchange/stl.h"

namespace fusee::readback {

/// Intersects horizontal rays from the z axis with triangles, in bins of azimuth with height ranges.
class RaySearch {
public:
    /// Keeps the triangles with heights in [low_mm, high_mm].
    RaySearch(const solid::Mesh& mesh, double low_mm, double high_mm);

    /// Distance from the axis of the outermost hit at height z; nothing if the ray meets no surface.
    [[nodiscard]] std::optional<double> outermost(double azimuth, double z_mm) const;

private:
    struct Facet {
        std::array<solid::Vec3, 3> corner;
        double low, high;
    };
    std::vector<Facet> facets_;
    core::AzimuthBins bins_;  ///< of facets_
};

}  // namespace fusee::readback
