#pragma once
#include <vector>

#include "fusee/solid/outline.h"
#include "fusee/solid/sweep.h"

namespace fusee::solid {

/// The longest run-out of a helix's groove [rad]: a longer one is no end of a groove but a turn of its own.
inline constexpr double kLongestRunOut = 5.0;

/// Directions over which every column has the same turns, the lowest first; the turns whose groove is cut there are marked.
struct AngularSpan {
    double low = 0.0, high = 0.0;  ///< directions u [rad]
    std::vector<bool> cut;         ///< [turn]; false: only its two lips, running out
};

/// Computes the points of the columns and how far apart they may stand.
class ColumnMaker {
public:
    ColumnMaker(const cam::Cam& cam, const std::vector<SectionPoint>& section, const Flanges& flanges);

    /// One turn of directions, cut where a groove begins or ends to run out: between two cuts every column has the same rails.
    [[nodiscard]] std::vector<AngularSpan> spans() const;

    [[nodiscard]] std::vector<Vec3> lower_rails(double u) const;  ///< flange, bottom to top
    [[nodiscard]] std::vector<Vec3> upper_rails(double u) const;
    [[nodiscard]] std::vector<Vec3> section_at(double psi) const;
    /// The two lips beyond the groove's ends, on their way into the flange's edge; `merged` once they are there.
    struct Lips {
        Vec3 lower, upper;
        bool merged = false;
    };
    [[nodiscard]] Lips run_out(double psi) const;
    /// What a run-out has to be at least, so that its lips turn on about the axis wherever another turn stands beside them: lips that turn
    /// back fold the land between the two (docs/theory/cams.md, eq. 8b).
    struct RunOut {
        double width = 0.0;  ///< [rad]
        double psi = 0.0;    ///< where it takes that much
        double land = 0.0;   ///< so that the land to a groove beside it does not turn over either [rad]; at least `width`
    };
    /// @param high beyond the groove's high end @pre a helix
    [[nodiscard]] RunOut run_out_needed(bool high) const;

    /// Largest radius of curvature of any rail at u [mm].
    [[nodiscard]] double flattest_mm(double u) const;
    /// Directions from which a helix's first lip has run in to which its last one has run out; one turn for a planar part [rad].
    [[nodiscard]] core::Range reach() const { return cam_.closed() ? core::Range{reach_.low, reach_.low + 2.0 * core::kPi} : reach_; }
    [[nodiscard]] double helix_radius_mm() const { return circle_; }  ///< of the circle that holds all of a helix; 0: planar
    [[nodiscard]] double z_low_mm() const { return z_low_; }
    [[nodiscard]] double z_high_mm() const { return z_high_; }

private:
    void measure_helix();

    const cam::Cam& cam_;
    const std::vector<SectionPoint>& section_;
    Flanges flanges_;
    double lip_, half_width_, z_low_ = 0.0, z_high_ = 0.0, circle_ = 0.0;
    core::Range reach_;  ///< psi of groove and run-outs
};

/// Outline of the upper flange as meshed, one point for each column: the parallel of the pitch curve (planar) or a circle (helix).
[[nodiscard]] std::vector<Point2> upper_outline(const Part& part);
/// Radius of that circle, which holds all of a helix [mm].
[[nodiscard]] double helix_radius_mm(const Part& part);
/// Where a closed polygon that holds the axis crosses +x, farthest out.
[[nodiscard]] double crossing_at_zero(const std::vector<Point2>& ring);

/// Directions from `low` to `high`, both included, so that the sagitta of every rail stays within the tolerance; evenly stretched.
[[nodiscard]] std::vector<double> place_columns(const ColumnMaker& maker, double low, double high, double tolerance_mm);

}  // namespace fusee::solid
