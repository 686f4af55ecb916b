#pragma once
#include "fusee/core/finding.h"
#include "fusee/drawing/drawing.h"
#include "fusee/formats/format.h"
#include "fusee/solid/part.h"

namespace fusee::formats {

/// An external program that a step needs.
struct Tool {
    const char* rule;     ///< of the finding about the step
    const char* what;     ///< the step
    bool there;           ///< it is installed
    const char* package;  ///< that contains it
    const char* undone;   ///< the work left undone without it
    const char* source;
};
/// A pass, or a warning if the tool is missing.
[[nodiscard]] core::Finding done_by(const Tool& tool, const solid::Part& part);

/// The sheets of the part's shop drawing, drawn once.
[[nodiscard]] const std::vector<drawing::Sheet>& sheets_of(PartExport& out);
/// The input of that drawing.
[[nodiscard]] drawing::Subject subject_of(const PartExport& out);

}  // namespace fusee::formats
