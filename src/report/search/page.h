#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "fusee/report/search.h"

/// The sections of the paper's figure 9, each a pure function of its data.
namespace fusee::report {

[[nodiscard]] std::string costs_section(const SearchReport& report);    ///< cost over each variable and over the generations
[[nodiscard]] std::string springs_section(const SearchReport& report);  ///< torques and dead-band
[[nodiscard]] std::string cams_section(const SearchReport& report);     ///< arms and drawings
/// search.json without the old spelling of renamed fields.
[[nodiscard]] nlohmann::ordered_json search_object(const SearchReport& report);

}  // namespace fusee::report
