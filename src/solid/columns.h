#pragma once
#include <vector>

#include "fusee/solid/sweep.h"

namespace fusee::solid {

/// One vertical line of vertices at direction u: flange rails, the groove's section for every turn j that has psi = u + 2 pi j, flange rails.
struct ColumnPoints {
    std::vector<Vec3> lower, upper;          ///< flange rails, bottom to top
    std::vector<std::vector<Vec3>> slots;    ///< [turn][section point]
};

/// Computes columns and how far apart they may stand.
class ColumnMaker {
public:
    ColumnMaker(const cam::Cam& cam, const std::vector<SectionPoint>& section, const Flanges& flanges);

    /// Turns first <= j < last that have a groove at direction u in [psi_low, psi_low + 2 pi).
    [[nodiscard]] int turns_at(double u) const;
    [[nodiscard]] ColumnPoints at(double u, int turns) const;
    /// Largest radius of curvature of any rail at u [mm].
    [[nodiscard]] double flattest_mm(double u) const;
    [[nodiscard]] double z_low_mm() const { return z_low_; }
    [[nodiscard]] double z_high_mm() const { return z_high_; }

private:
    const cam::Cam& cam_;
    const std::vector<SectionPoint>& section_;
    Flanges flanges_;
    double lip_, half_width_, z_low_ = 0.0, z_high_ = 0.0, circle_ = 0.0;
};

/// Directions from `low` to `high`, both included, so that the sagitta of every rail stays within the tolerance; evenly stretched.
[[nodiscard]] std::vector<double> place_columns(const ColumnMaker& maker, double low, double high, double tolerance_mm);

}  // namespace fusee::solid
