#pragma once
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/solid/mesh.h"
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

}  // namespace fusee::solid
