#include "key.h"

namespace fusee::profile {

#define FIELD(member) \
    [](auto& p) -> auto& { return p.member; }

std::vector<Key> compensation_keys() {
    const std::string t = "compensation.";
    const Limits shrink = within(-10, 10);
    return {
        number(t + "shrink_x_percent", kPercent, shrink, "measured shrinkage of a length along x; k_xx_compensated.* are larger by it",
               FIELD(compensation.shrink[0])),
        number(t + "shrink_y_percent", kPercent, shrink, "the same along y", FIELD(compensation.shrink[1])),
        number(t + "shrink_z_percent", kPercent, shrink, "the same along z, the part's axis", FIELD(compensation.shrink[2])),
        number(t + "bore_offset_mm", kMm, within(-2, 2),
               "measured loss of a bore's diameter without shrinkage; bores of k_xx_compensated.* are wider by it",
               FIELD(compensation.bore_offset)),
        number(t + "cable_axis_mm", kMm, within(-10, 10),
               "distance of the cable's neutral axis from the floor beyond d/2: both cams are cut with arms smaller by it",
               FIELD(k_se.allowance.cable_axis)),
        number(t + "k_se_contour_mm", kMm, within(-2, 2),
               "measured excess of K_SE's contour along its normal, from its inspection sheet; the cam is cut with arms smaller by it",
               FIELD(k_se.allowance.contour)),
        number(t + "k_pe_contour_mm", kMm, within(-2, 2), "the same of K_PE", FIELD(k_pe.allowance.contour)),
    };
}

#undef FIELD

}  // namespace fusee::profile
