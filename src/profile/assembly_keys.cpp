#include "key.h"

namespace fusee::profile {

#define FIELD(member) \
    [](auto& p) -> auto& { return p.member; }

std::vector<Key> assembly_keys() {
    return {
        number("assembly.motor_distance_mm", kMm, or_zero(1, 10000),
               "joint's axis to the motors' axes, along the cables; 0 = the least that the bodies need", FIELD(assembly.motor_distance)),
        number("assembly.k_pe_direction_deg", kDeg, within(-360, 360),
               "in which the agonist's K_PE pulls its cable off its motor's axis; 90 = towards the joint, 0 = outwards",
               FIELD(assembly.k_pe_direction)),
        number("assembly.joint_range_deg", kDeg, or_zero(1, 720),
               "of the joint between its stops; 0 = what the springs and one turn of cable allow", FIELD(assembly.joint_range)),
        number("assembly.gap_mm", kMm, within(0.01, 1000), "between bodies that move against each other, where the layout places them",
               FIELD(assembly.gap)),
        yes_or_no("assembly.frame", "with a plate and brackets that hold what is fixed", FIELD(assembly.frame)),
        number("assembly.wall_mm", kMm, within(0.1, 1000), "of the carriage and of the plate under K_PE's spring", FIELD(assembly.wall)),
    };
}

#undef FIELD

}  // namespace fusee::profile
