#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/solid/part.h"
#include "fusee/spring/base_spring.h"

namespace fusee::checks {

/// The cable as bought. Limits that are 0 are taken from the construction's entry in docs/checks.md.
struct Cable {
    double diameter = 1e-3;              ///< d [m]
    std::string construction = "fibre";  ///< "fibre", "7x7", "7x19", "7x49"
    double min_bend_ratio = 0.0;         ///< least D/d, D = 2 rho - d = groove floor diameter; 0 = by construction
    double breaking_load = 0.0;          ///< [N]; 0 = not checked
    double max_pressure = 0.0;           ///< allowed bearing pressure 2T/(D d) of the part's material [Pa]; 0 = not checked
    double max_fleet = 0.0;              ///< [rad]; 0 = 2 deg (grooved)
};

enum class ProcessKind { kFdm, kSla, kSls, kMill };
[[nodiscard]] const char* to_string(ProcessKind kind);  ///< "fdm", "sla", "sls", "mill"

/// How and where the part is made. Limits that are 0 are taken from the process's entry in docs/checks.md.
struct Process {
    ProcessKind kind = ProcessKind::kFdm;
    double build_x = 0.2, build_y = 0.2, build_z = 0.2;  ///< build volume or stock [m]
    double min_wall = 0.0;                               ///< [m]
    double min_hole = 0.0;                               ///< diameter [m]
    double max_overhang = 0.0;                           ///< of a face that looks down, from the vertical [rad]; FDM
    double cutter_radius = 0.0;                          ///< smallest ball or end mill at hand [m]; mill
    double tolerance = 0.0;                              ///< of a contour, one side [m]
};

/// All that a rule may look at.
struct Design {
    const solid::Part& part;
    const spring::BaseSpring& spring;
    const Cable& cable;
    const Process& process;
};

/// One rule: pure, one file under src/checks, returns a finding for what it measured (passes too), or none where it does not apply.
struct Rule {
    const char* id;      ///< "group.name"
    const char* title;   ///< what it guards against
    const char* source;  ///< of the default limit
    std::function<core::Findings(const Design&)> run;
    bool needs_mesh = false;  ///< looks at the solid, not only at cam, options and springs
};

/// Every rule, in the order in which they are reported.
[[nodiscard]] std::span<const Rule> rules();
/// Runs every rule on one part.
[[nodiscard]] core::Findings check(const Design& design);
/// Every rule but those that need the solid: what a search asks of a part whose mesh is still empty (docs/theory/co_design.md).
[[nodiscard]] core::Findings check_without_mesh(const Design& design);

}  // namespace fusee::checks
