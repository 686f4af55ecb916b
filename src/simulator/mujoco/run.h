#pragma once
#include <map>
#include <string>
#include <vector>

#include "figures.h"

namespace fusee::mujoco {

using Columns = std::map<std::string, std::vector<double>>;

/// One run: commands hold from their row to the next; a sensor or joint is read at the time of its row, before the command of the next.
/// It begins in the first keyframe, or in the pose of the file, and where columns JOINT_begin_UNIT say. Several inputs may be one
/// actuator's: their sum.
/// @param inputs t_s, and actuators and begins by name. @param outputs names: sensors, SENSOR_UNIT, SENSOR_0, JOINT_rad, JOINT_rad_per_s
/// @param timestep longest step of integration [s]
/// @throws core::InvalidInput for a name that the model lacks, or if the integration diverges
[[nodiscard]] Columns simulate(mjModel& model, mjData& data, double timestep, const Columns& inputs,
                               const std::vector<std::string>& outputs);

}  // namespace fusee::mujoco
