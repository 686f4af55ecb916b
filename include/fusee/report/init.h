#pragma once
#include <string>

#include "fusee/search/init.h"

namespace fusee::report {

/// The result of `fusee init` for a terminal: what was chosen and the next commands, or the binding limits and the nearest change.
/// @param file as the user named it
[[nodiscard]] std::string init_text(const search::init::Result& result, const std::string& file);

}  // namespace fusee::report
