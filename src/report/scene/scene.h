#pragma once
#include <string>
#include <vector>

#include "design/page.h"

namespace fusee::report {

/// The joint of a page's 3D view as JSON (docs/report.md): meshes, bodies, poses, cables, cam tables, findings with a place, curves. "<" is
/// written as an escape, so that the text can stand in a script element. @pre design.assembly
[[nodiscard]] std::string scene_json(const DesignReport& design, const std::vector<NumberedFinding>& findings);

/// The section of report.html with the joint in 3D and its script. A design without assembly gets the reason; "" if there is none.
[[nodiscard]] std::string joint_viewer_section(const DesignReport& design, const std::vector<NumberedFinding>& findings);

}  // namespace fusee::report
