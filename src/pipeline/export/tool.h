#pragma once
#include "fusee/core/finding.h"
#include "fusee/solid/part.h"

namespace fusee::pipeline {

/// Somebody else's program that a step needs.
struct Tool {
    const char* rule;     ///< of the finding that says whether the step was done
    const char* what;     ///< the step does
    bool there;           ///< it is installed
    const char* package;  ///< that holds it
    const char* undone;   ///< what has not been done without it
    const char* source;
};
/// Passed, or to review where the tool is missing: a step left out is said, never silent.
[[nodiscard]] core::Finding done_by(const Tool& tool, const solid::Part& part);

}  // namespace fusee::pipeline
