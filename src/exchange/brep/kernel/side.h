#pragma once
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <vector>

#include "fusee/solid/part.h"

namespace fusee::exchange::brep {

/// The lateral faces of a part, groove included, and the two rims at which its flat faces end.
struct Side {
    std::vector<TopoDS_Face> faces;
    TopoDS_Wire lower_rim, upper_rim;  ///< counter-clockwise seen from above
    double z_low_mm = 0.0, z_high_mm = 0.0;
    double lower_lip_mm = 0.0;  ///< z of the lower flange's inner face
    double deviation_mm = 0.0;  ///< of the splines from their rails
};
/// @param idle_pieces number of faces along a planar part's idle arc, in each strip
[[nodiscard]] Side side_of(const solid::Part& part, int idle_pieces);

}  // namespace fusee::exchange::brep
