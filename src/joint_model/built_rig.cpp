#include "fusee/joint_model/built_rig.h"

#include <algorithm>

namespace fusee::joint_model {

BuiltRig::BuiltRig(const gap_case::NominalRig& nominal)
    : reference(gap_case::reference_of(nominal)), joint_inertia(nominal.joint_inertia), joint_viscous(nominal.joint_viscous) {
    stop_stiffness *= reference.of("Nm/rad");
    for (BuiltSide& side : sides) {
        side.ratio = nominal.ratio();
        side.motor_inertia = nominal.motor_inertia;
        side.gear.load_friction = nominal.gear_load_friction;
        side.gear.viscous = nominal.motor_viscous;
    }
}

void BuiltRig::assemble(const NominalCams& cams) {
    for (BuiltSide& side : sides) {
        side.se = cams.series(side.se_build);
        side.pe = cams.parallel(side.pe_build);
        if (side.se_terms.slope != 0.0) side.se = side.se.scaled([&](double share) { return side.se_terms.factor(share); });
        if (side.pe_terms.slope != 0.0) side.pe = side.pe.scaled([&](double share) { return side.pe_terms.factor(share); });
    }
}

bool BuiltRig::drifts() const {
    return terms.zero.is_on() || std::any_of(sides.begin(), sides.end(), [](const BuiltSide& side) {
               const GearTerms& gear = side.gear.terms;
               return gear.friction_drift.is_on() || gear.torque_drift.is_on() || side.se_terms.drift.is_on() ||
                      side.pe_terms.drift.is_on();
           });
}

bool BuiltRig::has_memory() const {
    return std::any_of(sides.begin(), sides.end(),
                       [](const BuiltSide& side) { return side.se_terms.have_memory() || side.pe_terms.have_memory(); });
}

}  // namespace fusee::joint_model
