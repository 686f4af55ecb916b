#pragma once
#include <string>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"

namespace fusee::solid {

/// A prism that is taken away from a part: a convex ring over a height range, standing along z or (radial) along +x.
struct Cutter {
    std::string name;     ///< "anchor", "leg_slot", "mark", "set_screw"
    Ring ring;            ///< [mm]; radial: (y, z) of the section
    double low_mm = 0.0;  ///< z, or x for a radial cutter
    double high_mm = 0.0;
    bool radial = false;
    [[nodiscard]] Mesh mesh() const;
};

/// Heights and outline that the cutters have to fit.
struct PartFrame {
    double z_low_mm = 0.0, z_high_mm = 0.0;
    Ring upper_outline;
    double tolerance_mm = 0.0;
};
/// The holes, slots and marks of a part, in the order in which they are cut.
[[nodiscard]] std::vector<Cutter> make_cutters(const cam::Cam& cam, const PartOptions& options, const PartFrame& frame);

}  // namespace fusee::solid
