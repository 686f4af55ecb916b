#pragma once
#include <string>

#include "fusee/report/search.h"

/// The pieces of the paper's figure 9, each pure text from data.
namespace fusee::report {

[[nodiscard]] std::string costs_section(const SearchReport& report);    ///< cost over each variable and over the generations
[[nodiscard]] std::string springs_section(const SearchReport& report);  ///< torques and dead-band
[[nodiscard]] std::string cams_section(const SearchReport& report);     ///< arms and drawings

}  // namespace fusee::report
