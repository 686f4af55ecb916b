#pragma once
#include "fusee/core/finding.h"
#include "fusee/gap_case/case_template.h"
#include "fusee/mjcf/twin.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"

/// The rig that a profile describes, for measurements and for simulators.
namespace fusee::pipeline {

struct CaseTemplateOptions {
    int springs_rows = 200;  ///< of nominal_springs.csv, above the springs' stops; at least 8
};

/// The empty gap case of the joint that a profile describes: radii, friction, inertias and springs as designed (docs/gap.md). A case has no
/// preload: springs that rest on stops continue below them to zero torque, as the cam on its base spring would without a stop
/// (`springs_without_stops`); angles count from there.
/// Refusal: the law's. @throws core::InvalidInput naming a key that a case cannot hold: no parts, no preload for a law that needs one,
/// friction other than in proportion to the load
[[nodiscard]] core::Outcome<gap_case::CaseTemplate> case_template(const profile::Profile& profile, const CaseTemplateOptions& options = {});

/// A law's torques over deflection, continued below the springs' stops to (0, 0) as if the base springs could unwind there: from the state
/// z = 0 at x = 0 to the preload z_0 at x = L, where the law begins with its torque F_0,
///     z' = c + (s - c) (x/L)^(s/a),   a = z_0/L,   s = F_0/(k z_0),   c = a^2/s,   F = k z z'                (docs/gap.md, eq. 5)
/// Torque, energy 1/2 k z_0^2 and arm (r_c/z' of K_SE, z' of K_PE) are those of the law at L, so that the cams that follow from the curves
/// are the designed ones above it, and every arm below is finite. Both springs see the same angle: L is the greater of z_0/s.
struct SpringsWithoutStops {
    std::vector<gap_case::NominalRig::SpringRow> rows;
    double rest_deflection = 0.0;  ///< L [rad]
};
/// @throws core::InvalidInput if a base spring has no preload, or fewer than 8 rows are asked for
[[nodiscard]] SpringsWithoutStops springs_without_stops(const spring::SpringLaw& law, const spring::BaseSpring& series,
                                                        const spring::BaseSpring& parallel, int rows);

/// The design's joint for the simulator MuJoCo, with inertia and drag of `[dynamics]`; what the profile states beyond springs and friction
/// of gears and bearing is named as not expressed. @throws core::InvalidInput for one of the paper's relatives
[[nodiscard]] mjcf::Twin twin_of(const ResolvedDesign& design);

}  // namespace fusee::pipeline
