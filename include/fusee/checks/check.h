#pragma once
#include <span>

#include "fusee/checks/rule.h"
#include "fusee/solid/part.h"
#include "fusee/spring/base_spring.h"

/// Example:
/// @code
/// const core::Findings found = checks::check({part, spring, cable, process});  // part: solid::Part with its mesh
/// for (const core::Finding& f : found)
///     if (f.severity != core::Severity::kPass) std::cout << core::to_line(f) << '\n';
/// if (core::any_error(found)) return 1;  // a limit named "required" is broken: the part cannot be made
/// @endcode
namespace fusee::checks {

/// How the cable's end is held behind its anchor hole.
enum class Termination { kKnot, kCrimp, kSplice };

/// The cable as bought. Limits that are 0 are taken from the construction's entry in docs/rules.md.
struct Cable {
    double diameter = 1e-3;              ///< d [m]
    std::string construction = "fibre";  ///< "fibre", "7x7", "7x19", "7x49"
    double min_bend_ratio = 0.0;         ///< least D/d, D = 2 rho - d = groove floor diameter; 0 = by construction
    double breaking_load = 0.0;          ///< [N]; 0 = estimated by construction and diameter
    double max_pressure = 0.0;           ///< allowed bearing pressure 2T/(D d) of the part's material [Pa]; 0 = by material
    double max_fleet = 0.0;              ///< [rad]; 0 = 2 deg (grooved)
    Termination termination = Termination::kKnot;
};

enum class ProcessKind {
    kFdm,
    kSla,
    kSls,
    kMill,   ///< three axes, the tool along the part's axis
    kMill4,  ///< a fourth axis turns the part under the tool
    kEdm,    ///< plates cut by wire erosion, stacked
    kLaser,  ///< plates cut by laser, stacked
};
/// "fdm", "sla", "sls", "mill", "mill4", "edm", "laser"
[[nodiscard]] const char* to_string(ProcessKind kind);

inline constexpr const char* kByProcess = "by_process";

/// What the parts are made of. Values that are 0 are taken from the material's entry in docs/rules.md, table 5.
struct MaterialOptions {
    std::string kind = kByProcess;  ///< kByProcess: the one that shops use most; else a name of material_table()
    double strength = 0.0;          ///< tensile strength of a plastic, yield strength of a metal [Pa]
    double modulus = 0.0;           ///< E [Pa]
    double density = 0.0;           ///< [kg/m^3]
    std::string designation = {};   ///< with its condition, for drawing and STEP; empty: the kind's
};

/// How and where the part is made. Limits that are 0 are taken from the process's entry in docs/rules.md.
struct Process {
    ProcessKind kind = ProcessKind::kFdm;
    double build_x = 0.2, build_y = 0.2, build_z = 0.2;  ///< build volume or stock [m]
    double min_wall = 0.0;                               ///< [m]
    double min_hole = 0.0;                               ///< diameter [m]
    double max_overhang = 0.0;                           ///< of a downward face, from the vertical [rad]; FDM
    double cutter_radius = 0.0;  ///< smallest available ball or end mill; wire with its gap, half a laser's kerf [m]
    double layer = 0.0;          ///< height of a printed layer [m]
    double tolerance = 0.0;      ///< of a contour, one side [m]
    MaterialOptions material;
};

[[nodiscard]] bool is_printed(const Process& process);
[[nodiscard]] bool is_milled(const Process& process);   ///< on three or four axes
[[nodiscard]] bool is_stacked(const Process& process);  ///< from plates cut by wire or laser

/// The input of a rule.
struct Design {
    const solid::Part& part;
    const spring::BaseSpring& spring;
    const Cable& cable;
    const Process& process;
    std::span<const Override> overrides = {};  ///< limits that replace the rules' own
};

/// All rules, in the order of the report.
[[nodiscard]] std::span<const Rule> rules();
/// nullptr if no rule has this id.
[[nodiscard]] const Rule* find_rule(std::string_view id);
/// The subject of a group of rules, e.g. "shaft and hub" for "shaft". @pre the group of some rule
[[nodiscard]] const char* group_title(std::string_view group);
/// All rules with their limits and sources, as Markdown tables (`fusee rules --markdown`).
[[nodiscard]] std::string rules_reference();

/// Runs every rule on one part.
[[nodiscard]] core::Findings check(const Design& design);
/// Runs every rule that does not need the solid. A search checks a part without a mesh in this way (docs/theory/co_design.md).
[[nodiscard]] core::Findings check_without_mesh(const Design& design);

}  // namespace fusee::checks
