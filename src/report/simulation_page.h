#pragma once
#include <string>

#include "fusee/report/simulation.h"

/// The pieces of simulation.html, each pure text from data; "" where there is nothing to show.
namespace fusee::report {

[[nodiscard]] std::string joint_charts(const Simulation& simulation);      ///< dead-band, condition (6), stiffness
[[nodiscard]] std::string push_charts(const Simulation& simulation);       ///< paths and loops
[[nodiscard]] std::string subsystem_charts(const Simulation& simulation);  ///< motor, frame, noise

}  // namespace fusee::report
