#pragma once
#include "fusee/checks/check.h"

/// One function per rule, each in the file that bears its name; registry.cpp lists them in the order of the report.
namespace fusee::checks {

Rule cable_bend_ratio();
Rule cable_breaking_load();
Rule cable_pressure();
Rule cable_fleet();
Rule cable_groove_angle();
Rule cable_free_path();
Rule cam_arm_range();
Rule cam_contour_radius();
Rule groove_depth();
Rule groove_radius();
Rule groove_throat();
Rule groove_pitch();
Rule groove_neighbour_turns();
Rule spring_travel();
Rule spring_torsion_angle();
Rule spring_load();
Rule spring_stress();
Rule spring_buckling();
Rule structure_wall_to_bore();
Rule structure_idle_curvature();
Rule structure_leg_slot();
Rule structure_anchor();
Rule structure_anchor_floor();
Rule shaft_key();
Rule shaft_screw();
Rule shaft_hub_wall();
Rule process_build_volume();
Rule process_overhang();
Rule process_support();
Rule process_wall();
Rule process_hole();
Rule process_cutter();
Rule process_undercut();
Rule process_contour_error();

}  // namespace fusee::checks
