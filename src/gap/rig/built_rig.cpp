#include "fusee/gap/built_rig.h"

namespace fusee::gap {

BuiltRig::BuiltRig(const NominalRig& nominal)
    : ratio(nominal.ratio()),
      motor_inertia(nominal.motor_inertia),
      joint_inertia(nominal.joint_inertia),
      joint_viscous(nominal.joint_viscous) {
    for (BuiltSide& side : sides) {
        side.gear.load_friction = nominal.gear_load_friction;
        side.gear.viscous = nominal.motor_viscous;
    }
}

void BuiltRig::assemble(const NominalCams& cams) {
    for (BuiltSide& side : sides) {
        side.se = cams.series(side.se_build);
        side.pe = cams.parallel(side.pe_build);
    }
}

}  // namespace fusee::gap
