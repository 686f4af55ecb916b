#pragma once
#include <span>
#include <string>

#include "fusee/checks/check.h"

namespace fusee::checks {

/// What a material of printed, milled and cut parts bears (docs/rules.md, table 5).
struct Material {
    const char* name;         ///< "pla"
    double strength;          ///< tensile strength of a plastic, yield strength of a metal [Pa]
    double permanent;         ///< allowed permanent bending stress [Pa]
    double bearing;           ///< allowed pressure of a cable, a key or a wire on it: its strength in compression [Pa]
    double modulus;           ///< E, loaded for a short time [Pa]
    double creep_modulus;     ///< E, loaded for years [Pa]
    double density;           ///< [kg/m^3]
    const char* designation;  ///< with its condition, as a shop orders it: "EN AW-6082 T6 (EN 573-3, EN 515)"
    const char* source;
};
[[nodiscard]] std::span<const Material> material_table();
/// The material that shops use most for a process.
[[nodiscard]] const Material& usual_material(ProcessKind kind);
/// The process's material: the stated or the usual one, with the values that the profile states in place of the table's. A stated strength
/// scales permanent stress and bearing strength with it, a stated modulus the creep modulus. @throws InvalidInput naming material.kind
[[nodiscard]] Material material_of(const Process& process);
/// The material for drawing and files: the stated designation, else the one of its kind.
[[nodiscard]] std::string designation_of(const Process& process);
/// Allowed pressure on a design's material [Pa]: cable.max_pressure if the profile states it, else the material's.
[[nodiscard]] double bearing_strength(const Design& design);
/// "as stated (cable.max_pressure_MPa)" or "of pla"
[[nodiscard]] std::string bearing_origin(const Design& design);

}  // namespace fusee::checks
