#pragma once
#include <string>

#include "fusee/search/init.h"

namespace fusee::report {

/// The result of `fusee init` for a terminal: what was chosen and the next commands, or the binding limits and the nearest change.
/// @param file as the user named it @param more options that are no answers, for a command that is to be given again: " --yes"
[[nodiscard]] std::string init_text(const search::init::Result& result, const std::string& file, const std::string& more = "");

/// Dead-band, sizes, outside torque, springs and material of a design, before it is written, and the law that was changed.
/// @pre result.design
[[nodiscard]] std::string init_summary(const search::init::Result& result);

}  // namespace fusee::report
