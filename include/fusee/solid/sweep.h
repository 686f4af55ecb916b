#pragma once
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"

namespace fusee::solid {

/// The flanges beside the groove of one part.
struct Flanges {
    double lower_height_mm = 0.0;  ///< above the lips; helix: both flanges are one circle, this far outside the farthest lip
    double upper_height_mm = 0.0;
    double rib_mm = 1.0;          ///< thickness
    double core_radius_mm = 0.0;  ///< circle about the axis that the lower flange must contain (boss); 0 = none
};
[[nodiscard]] Flanges flanges_of(const PartOptions& options);

/// A swept lateral surface, open at top and bottom: the rings are its boundary, counter-clockwise seen from above.
struct SweptBody {
    Mesh mesh;
    std::vector<std::uint32_t> lower_ring, upper_ring;
    double z_low_mm = 0.0, z_high_mm = 0.0;
    double lower_lip_mm = 0.0;        ///< z of the lower flange's inner face
    std::vector<double> columns_psi;  ///< directions of the columns over one turn; a helix has grooves at these plus whole turns
};

/// Sweeps the groove's section along the cam's path, with its flanges. The vertices lie on the analytic surface, one column for each psi;
/// `tolerance_mm` sets their density (sagitta rho dpsi^2/8). A helix's groove ends in a flat wall at both ends of `cam.groove_psi`; beyond
/// them its land runs out into the flange. `section` is bottom to top; two points (the lips) give the body without a groove.
/// @pre helix: neighbouring turns do not touch (see `least_turn_gap_mm`)
[[nodiscard]] SweptBody sweep(const cam::Cam& cam, const std::vector<SectionPoint>& section, const Flanges& flanges, double tolerance_mm);

/// Least land between the lips of neighbouring turns [mm]; infinity when there is only one turn.
[[nodiscard]] double least_turn_gap_mm(const cam::Cam& cam, const std::vector<SectionPoint>& section);

/// The longest run-out of a helix's groove [rad]: a longer one would be another turn, not the end of a groove.
inline constexpr double kLongestRunOut = 5.0;

/// Directions over which every column has the same turns, the lowest first. The turns with a cut groove are marked.
struct AngularSpan {
    double low = 0.0, high = 0.0;  ///< directions u [rad]
    std::vector<bool> cut;         ///< [turn]; false: only the two lips of its run-out
};

/// Computes the points of the columns and their largest spacing.
class ColumnMaker {
public:
    ColumnMaker(const cam::Cam& cam, const std::vector<SectionPoint>& section, const Flanges& flanges);

    /// One turn of directions, divided where a groove or a run-out begins or ends: within a span every column has the same rails.
    [[nodiscard]] std::vector<AngularSpan> spans() const;

    [[nodiscard]] std::vector<Vec3> lower_rails(double u) const;  ///< flange, bottom to top
    [[nodiscard]] std::vector<Vec3> upper_rails(double u) const;
    [[nodiscard]] std::vector<Vec3> section_at(double psi) const;
    /// The two lips beyond the groove's ends, between the groove and the flange's edge; `merged` on the edge.
    struct Lips {
        Vec3 lower, upper;
        bool merged = false;
    };
    [[nodiscard]] Lips run_out(double psi) const;
    /// The least width of a run-out with which its lips keep turning about the axis wherever another turn is beside them. Lips that turn
    /// back fold the land between both turns (docs/theory/cams.md, eq. 8b).
    struct RunOut {
        double width = 0.0;  ///< [rad]
        double psi = 0.0;    ///< where that width is needed
        double land = 0.0;   ///< width with which the land to the next groove does not fold either [rad]; at least `width`
    };
    /// @param high beyond the groove's high end @pre a helix
    [[nodiscard]] RunOut run_out_needed(bool high) const;

    /// Largest radius of curvature of any rail at u [mm].
    [[nodiscard]] double flattest_mm(double u) const;
    /// Directions between the outer ends of a helix's two run-outs; one turn for a planar part [rad].
    [[nodiscard]] core::Range reach() const { return cam_.closed() ? core::Range{reach_.low, reach_.low + 2.0 * core::kPi} : reach_; }
    [[nodiscard]] double helix_radius_mm() const { return circle_; }  ///< of the circle that contains all of a helix; 0: planar
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
/// Radius of that circle, which contains all of a helix [mm].
[[nodiscard]] double helix_radius_mm(const Part& part);
/// Distance of the farthest crossing of the x axis by a closed polygon around the origin, on the side of `sign`: 1 or -1.
[[nodiscard]] double crossing_at_zero(const std::vector<Point2>& ring, double sign = 1.0);

/// Directions from `low` to `high`, both included, so that the sagitta of every rail stays within the tolerance; their spacing is scaled
/// evenly to fit the range.
[[nodiscard]] std::vector<double> place_columns(const ColumnMaker& maker, double low, double high, double tolerance_mm);

}  // namespace fusee::solid
