#pragma once
#include <optional>

#include "fusee/spring/base_spring.h"

/// Quantities of a base spring that follow from its wire. Its data may be unknown.
namespace fusee::checks {

/// Are wire and mean coil diameter known?
bool coil_known(const spring::BaseSpring& spring);
/// C = D/w. @pre coil_known
double spring_index(const spring::BaseSpring& spring);
/// Largest stress of the wire under `load` [Nm or N], in Pa: of bending (torsion spring), of shear (compression spring). @pre coil_known
double wire_stress(const spring::BaseSpring& spring, double load);
/// Compression spring with ground ends: travel until all coils touch [m]; none where free length, coils or wire are not known.
std::optional<double> travel_to_solid(const spring::BaseSpring& spring);
/// Inside diameter of the coils [m]; of a torsion spring: wound by `state` [rad]. @pre coil_known, active coils known if torsion
double inside_diameter(const spring::BaseSpring& spring, double state);

}  // namespace fusee::checks
