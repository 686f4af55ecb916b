#pragma once
#include <optional>
#include <span>
#include <string>

#include "fusee/checks/check.h"
#include "fusee/core/units.h"

/// The tables of docs/rules.md: cables, processes, keys, materials, sizes of bought parts.
namespace fusee::checks {

/// Default bending limits of a cable construction, as D/d with D the diameter of the groove's floor.
struct CableLimits {
    const char* construction;
    double critical;     ///< below: error
    double recommended;  ///< below: warning
    double friction;     ///< least coefficient on the groove's floor: what the wound cable takes from its anchor
    const char* source;
    [[nodiscard]] bool is_fibre() const;
};
[[nodiscard]] std::span<const CableLimits> cable_table();
/// @throws InvalidInput naming cable.construction
[[nodiscard]] const CableLimits& cable_limits(const std::string& construction);

/// Share of its breaking load that is left in a cable bent at D/d; linear in log(D/d) between the rows of table 2, one for wire, one for
/// fibre. @throws InvalidInput naming cable.construction
[[nodiscard]] double strength_left(const std::string& construction, double bend_ratio);

/// An end of a cable, as it is held behind its hole.
struct TerminationLimits {
    Termination kind;
    bool fibre;
    double strength;  ///< share of the cable's breaking load that it holds
    double width;     ///< of the thickened end, in cable diameters
    const char* source;
};
[[nodiscard]] std::span<const TerminationLimits> termination_table();
/// @throws InvalidInput naming cable.construction
[[nodiscard]] const TerminationLimits& termination_limits(const Cable& cable);
/// "knot", "crimp", "splice"
[[nodiscard]] const char* to_string(Termination kind);

/// Default minima of a process. 0 = the process has no such limit.
struct ProcessLimits {
    ProcessKind kind;
    double wall;            ///< thinnest wall [m]
    double loaded_wall;     ///< thinnest wall that carries load [m]
    double hole;            ///< least hole diameter [m]
    double overhang;        ///< largest angle of a downward face from the vertical [rad]
    double cutter_radius;   ///< smallest common cutter, wire with its gap, half a kerf [m]
    double tolerance;       ///< of a contour, one side [m]
    double feature;         ///< thinnest body that stands alone [m]
    double detail;          ///< narrowest slot or mark [m]
    core::Range fit;        ///< clearance of a bore on its shaft, in diameter [m]
    double layer;           ///< of a print [m]
    double roughness;       ///< Ra of faces as made [m]
    double fine_roughness;  ///< Ra of bores and contours made with care [m]
    const char* source;
};
[[nodiscard]] std::span<const ProcessLimits> process_table();
/// The table's row, with the values that `process` states in place of the defaults (min_wall replaces both walls).
[[nodiscard]] ProcessLimits process_limits(const Process& process);

/// Parallel key of DIN 6885-1: one range of shaft diameters.
struct KeySize {
    double above, up_to;  ///< shaft diameter [m], above < d <= up_to; the first range includes its lower end
    double width;         ///< b [m]
    double height;        ///< h [m]
    double shaft_depth;   ///< t1 [m]
    double hub_depth;     ///< t2 [m]
    /// Height of the key's side that presses on the hub, h - t1 [m].
    [[nodiscard]] double hub_side() const { return height - shaft_depth; }
};
[[nodiscard]] std::span<const KeySize> key_table();
/// nullptr where the standard has no key (d < 6 mm) or this table ends (d > 30 mm).
[[nodiscard]] const KeySize* key_size(double shaft_diameter);

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

// Sizes of bought parts: a suggested shaft, cable or wire has one of these (docs/guides/fix.md).

/// Diameters of one kind of part [mm], ascending.
struct StandardSizes {
    const char* what;  ///< "shaft"
    std::span<const double> mm;
    const char* source;

    /// The largest size up to `limit_mm`; none if all are larger. A size that misses the limit only by rounding (1e-9 relative) counts.
    [[nodiscard]] std::optional<double> at_most(double limit_mm) const;
    /// The smallest size from `limit_mm` on; none if all are smaller.
    [[nodiscard]] std::optional<double> at_least(double limit_mm) const;
};

[[nodiscard]] StandardSizes shaft_sizes();
[[nodiscard]] StandardSizes wire_sizes();   ///< spring wire
[[nodiscard]] StandardSizes screw_sizes();  ///< metric set screws, thread diameter
/// @throws InvalidInput naming cable.construction
[[nodiscard]] StandardSizes cable_sizes(const std::string& construction);

/// The breaking load that a usual cable of diameter `d` [m] has at least, in N: for a profile that states none.
/// @throws InvalidInput naming cable.construction
[[nodiscard]] double usual_cable(const std::string& construction, double d);
/// The breaking load that the strongest cable on sale has at diameter `d` [m], in N. @throws InvalidInput naming cable.construction
[[nodiscard]] double strongest_cable(const std::string& construction, double d);

/// Shear stress of a round shaft in torsion, 16 T/(pi d^3) [Pa]. @param torque T [Nm] @param diameter d [m], > 0
[[nodiscard]] double torsion_stress(double torque, double diameter);
/// Allowed shear stress of a shaft of ordinary steel [Pa]: 41 MPa with a keyway, 55 MPa without (ASME code for transmission shafting).
[[nodiscard]] double shaft_shear_limit(bool keyway);

}  // namespace fusee::checks
