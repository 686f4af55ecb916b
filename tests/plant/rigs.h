#pragma once
#include "fusee/plant/machine.h"

namespace fusee::plant::rigs {

/// Straight springs up to 3 rad; arms of the drawing are then the same everywhere.
inline Nominal straight(double se_rate, double pe_rate) {
    Nominal n;
    for (int i = 0; i <= 3000; ++i) {
        const double x = 1e-3 * i;
        n.springs.deflection.push_back(x);
        n.springs.se.push_back(se_rate * x);
        n.springs.pe.push_back(pe_rate * x);
    }
    n.torsion_rate = 0.4;
    n.compression_rate = 2000.0;
    return n;
}

/// Built as drawn: every tolerance 0.
inline Truth as_drawn(const Nominal& nominal) {
    Tolerance none;
    none.mu = none.radii = none.inertia = none.spring_rate = none.se_radius = none.pe_radius = 0.0;
    none.se_preload = none.pe_preload = none.torque_scale = none.joint_coulomb = none.joint_offset = 0.0;
    Random random(1, 1, 1);
    return build(nominal, none, random);
}

}  // namespace fusee::plant::rigs
