#pragma once
#include <span>
#include <string>

#include "fusee/checks/check.h"
#include "fusee/core/units.h"

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

}  // namespace fusee::checks
