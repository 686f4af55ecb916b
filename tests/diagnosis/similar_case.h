#pragma once
#include "fusee/gap_case/case.h"

namespace fusee::fixtures {

/// The same joint at `torque` times the torques and `radius` times the radii, with equal angles and times: inertias, drags and rates follow
/// (a rate of K_PE is a torque over a length squared), and so do its tolerances, the noise of its torque sensors and its rows.
inline gap_case::Case similar_case(gap_case::Case c, double torque, double radius) {
    gap_case::NominalRig& rig = c.rig;
    for (double* length : {&rig.capstan_radius, &rig.joint_radius, &c.tolerance.se_radius, &c.tolerance.pe_radius, &c.tolerance.pe_preload})
        *length *= radius;
    for (double* figure : {&rig.motor_inertia, &rig.joint_inertia, &rig.motor_viscous, &rig.joint_viscous, &rig.se_torsion_rate,
                           &c.tolerance.joint_coulomb, &c.sensors.torque_noise})
        *figure *= torque;
    rig.pe_compression_rate *= torque / (radius * radius);
    for (gap_case::NominalRig::SpringRow& row : rig.springs) {
        row.se_torque *= torque;
        row.pe_torque *= torque;
    }
    for (gap_case::BreakAway& row : c.rows.breakaway) {
        row.motor_torque *= torque;
        row.load_torque *= torque;
    }
    for (gap_case::SpringPull& row : c.rows.spring_pull) row.torque *= torque;
    for (gap_case::DeadBandRow& row : c.rows.dead_band) {
        row.cocontraction *= torque;
        row.push_torque *= torque;
    }
    for (gap_case::StiffnessRow& row : c.rows.joint_stiffness) {
        row.cocontraction *= torque;
        row.joint_torque *= torque;
    }
    for (gap_case::CocontractionRow& row : c.rows.cocontraction) row.motor_torque *= torque;
    for (gap_case::LogRow& row : c.rows.log) {
        row.torque_agonist *= torque;
        row.torque_antagonist *= torque;
        row.joint_torque *= torque;
    }
    return c;
}

}  // namespace fusee::fixtures
