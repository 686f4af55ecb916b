#include "fusee/report/diagnosis.h"
#include "scene/scene.h"

namespace fusee::report {

JointScene joint_scene(const pipeline::DesignReport& joint) { return {joint_plan_json(joint), scene_json(joint)}; }

}  // namespace fusee::report
