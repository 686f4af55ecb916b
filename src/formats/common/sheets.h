#pragma once
#include "fusee/formats/part_export.h"

namespace fusee::formats {

/// The sheets of the part's shop drawing, drawn once.
[[nodiscard]] const std::vector<drawing::Sheet>& sheets_of(PartExport& out);

}  // namespace fusee::formats
