#pragma once
#include "fusee/drawing/drawing.h"
#include "fusee/formats/format.h"

namespace fusee::formats {

/// The sheets of the part's shop drawing, drawn once.
[[nodiscard]] const std::vector<drawing::Sheet>& sheets_of(PartExport& out);
/// The input of that drawing.
[[nodiscard]] drawing::Subject subject_of(const PartExport& out);

}  // namespace fusee::formats
