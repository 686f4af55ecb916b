#include "coil.h"

#include <cmath>

#include "fusee/core/units.h"

namespace fusee::checks {

namespace {

constexpr double kDeadCoils = 2.0;  // ground ends: one inactive coil each

/// At the inside of a torsion spring's coil: 32 M K_B/(pi w^3), K_B = (4C^2 - C - 1)/(4C(C - 1)).
double bending_stress(const spring::BaseSpring& s, double torque) {
    const double c = spring_index(s);
    return 32.0 * torque * (4.0 * c * c - c - 1.0) / (4.0 * c * (c - 1.0)) / (core::kPi * std::pow(s.wire_diameter, 3));
}

/// At the inside of a compression spring's coil: 8 F D K_W/(pi w^3), K_W = (4C - 1)/(4C - 4) + 0.615/C (Wahl).
double shear_stress(const spring::BaseSpring& s, double force) {
    const double c = spring_index(s);
    return 8.0 * force * s.coil_diameter * ((4.0 * c - 1.0) / (4.0 * c - 4.0) + 0.615 / c) / (core::kPi * std::pow(s.wire_diameter, 3));
}

}  // namespace

bool coil_known(const spring::BaseSpring& s) { return s.wire_diameter > 0.0 && s.coil_diameter > s.wire_diameter; }

double spring_index(const spring::BaseSpring& s) { return s.coil_diameter / s.wire_diameter; }

double wire_stress(const spring::BaseSpring& s, double load) {
    return s.kind == spring::BaseKind::kTorsion ? bending_stress(s, load) : shear_stress(s, load);
}

std::optional<double> travel_to_solid(const spring::BaseSpring& s) {
    if (s.free_length <= 0.0 || s.active_coils <= 0.0 || s.wire_diameter <= 0.0) return std::nullopt;
    return s.free_length - (s.active_coils + kDeadCoils) * s.wire_diameter;
}

double inside_diameter(const spring::BaseSpring& s, double state) {
    if (s.kind == spring::BaseKind::kCompression) return s.coil_diameter - s.wire_diameter;
    const double turns = state / (2.0 * core::kPi);  // the wire keeps its length: more turns mean smaller coils
    return s.coil_diameter * s.active_coils / (s.active_coils + turns) - s.wire_diameter;
}

}  // namespace fusee::checks
