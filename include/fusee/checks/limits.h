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
    const char* source;
};
[[nodiscard]] std::span<const CableLimits> cable_table();
/// @throws InvalidInput naming cable.construction
[[nodiscard]] const CableLimits& cable_limits(const std::string& construction);

/// Share of its breaking load that is left in a cable bent at D/d (Sava, Crosby); linear in log(D/d) between the table's rows.
[[nodiscard]] double strength_left(double bend_ratio);

/// Default minima of a process. 0 = the process has no such limit.
struct ProcessLimits {
    ProcessKind kind;
    double wall;           ///< thinnest wall [m]
    double loaded_wall;    ///< thinnest wall that carries load [m]
    double hole;           ///< least hole diameter [m]
    double overhang;       ///< largest angle of a downward face from the vertical [rad]
    double cutter_radius;  ///< smallest common cutter, wire with its gap, half a kerf [m]
    double tolerance;      ///< of a contour, one side [m]
    double feature;        ///< thinnest body that stands alone [m]
    double detail;         ///< narrowest slot or mark [m]
    core::Range fit;       ///< clearance of a bore on its shaft, in diameter [m]
    double strength;       ///< allowed permanent bending stress of its usual material [Pa]
    double layer;          ///< of a print [m]
    const char* source;
};
[[nodiscard]] std::span<const ProcessLimits> process_table();
/// The table's row, with the values that `process` states in place of the defaults (min_wall replaces both walls).
[[nodiscard]] ProcessLimits process_limits(const Process& process);

/// Parallel key of DIN 6885-1: one range of shaft diameters.
struct KeySize {
    double above, up_to;  ///< shaft diameter [m], above < d <= up_to; the first range includes its lower end
    double width;         ///< b [m]
    double hub_depth;     ///< t2 [m]
};
[[nodiscard]] std::span<const KeySize> key_table();
/// nullptr where the standard has no key (d < 6 mm) or this table ends (d > 30 mm).
[[nodiscard]] const KeySize* key_size(double shaft_diameter);

}  // namespace fusee::checks
