#pragma once
#include "data/json.h"
#include "fusee/report/search.h"

namespace fusee::report {

/// search.json without the old spelling of renamed fields.
[[nodiscard]] Json search_object(const SearchReport& report);

}  // namespace fusee::report
