#pragma once
#include <string>

#include "fusee/report/report.h"
#include "page/bundle.h"

namespace fusee::report {

/// The joint of a page's 3D view as JSON (docs/report.md): meshes, bodies, poses, cables, cam tables, curves. @pre design.assembly
[[nodiscard]] std::string scene_json(const DesignReport& design);

/// The drawing along the axis as JSON. @pre design.assembly
[[nodiscard]] std::string joint_plan_json(const DesignReport& design);

/// Gives a page the scene and the drawing along the axis, and its script. @pre design.assembly
void add_scene(Page& page, const DesignReport& design);

}  // namespace fusee::report
