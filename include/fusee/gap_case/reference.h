#pragma once
#include <string_view>

#include "fusee/gap_case/case.h"

namespace fusee::gap_case {

/// What a rig has over the reference rig, whose springs load a capstan with 2.6 Nm at the end of their curves, with a capstan of 15 mm and
/// motors of 0.002 kg m^2. Sizes, limits and steps are written for that rig; on another one they are `of(unit)` times as large
/// (docs/theory/diagnosis.md, eq. 18), so that a diagnosis of similar rigs is the same. Angles have no reference.
struct Reference {
    double torque = 1.0;  ///< greatest load of a capstan by its springs
    double radius = 1.0;  ///< r_c
    double time = 1.0;    ///< sqrt(motor inertia/torque)

    /// Factor of a quantity in `unit`: "Nm", "Nms", "Nm/rad", "1/Nm", "m", "N/m", "s", "rad/s", "kg m^2"; 1 for "rad", "1", "".
    /// @throws core::InvalidInput naming a unit that is none of these
    [[nodiscard]] double of(std::string_view unit) const;
    /// The power of ten nearest to `torque`: set points are rounded to decimals of it.
    [[nodiscard]] double decade() const;
};

/// 1 for what the rig does not state (no springs, no radius, no inertia). The last bits of each are rounded off: the sum of two springs'
/// torques has another rounding on each rig.
[[nodiscard]] Reference reference_of(const NominalRig& rig);

/// Tolerances and sensors of a rig that states none: those of the reference rig, in its units. `digits`: rounded for a person.
[[nodiscard]] Tolerance usual_tolerance(const NominalRig& rig, int digits = 17);
[[nodiscard]] Sensors usual_sensors(const NominalRig& rig, int digits = 17);

}  // namespace fusee::gap_case
