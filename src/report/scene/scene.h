#pragma once
#include <string>
#include <vector>

#include "design/page.h"
#include "scene/marks.h"

namespace fusee::report {

/// The joint of a page's 3D view as JSON (docs/report.md): meshes, bodies, poses, cables, cam tables, findings with a place, curves. "<" is
/// written as an escape, so that the text can stand in a script element. @pre design.assembly
/// @param marks null: bodies have their own colours
[[nodiscard]] std::string scene_json(const DesignReport& design, const std::vector<NumberedFinding>& findings,
                                     const Marks* marks = nullptr);

/// The section of a page with the joint in 3D and its script. A design without assembly gets the reason; "" if there is none.
/// @param words HTML below the heading
[[nodiscard]] std::string joint_viewer_section(const DesignReport& design, const std::vector<NumberedFinding>& findings,
                                               const Marks* marks = nullptr, const std::string& words = {});

}  // namespace fusee::report
