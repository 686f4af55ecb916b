#pragma once
#include <string>

#include "fusee/report/simulation.h"

/// The pieces of simulation.html, and of what a terminal shows, each pure text from data; "" where there is nothing to show.
namespace fusee::report {

[[nodiscard]] std::string equilibria_section(const Simulation& simulation);  ///< those that were asked for
[[nodiscard]] std::string joint_charts(const Simulation& simulation);        ///< dead-band, condition (6), stiffness
[[nodiscard]] std::string push_charts(const Simulation& simulation);         ///< paths and loops
[[nodiscard]] std::string subsystem_charts(const Simulation& simulation);    ///< motor, frame, noise
[[nodiscard]] std::string wrap_section(const Simulation& simulation);        ///< loops of the cables on their cams

/// The equilibria for a terminal.
[[nodiscard]] std::string equilibria_text(const Simulation& simulation);

}  // namespace fusee::report
