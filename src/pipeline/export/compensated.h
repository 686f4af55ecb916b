#pragma once
#include "fusee/core/finding.h"
#include "judge.h"

namespace fusee::pipeline {

/// Findings for the part with the bore of its compensated file, if worse than those of the nominal part: a wall that a slicer would not
/// fill. Empty without a compensated bore. Rules of the fit on the shaft judge the finished, nominal bore.
/// @param nominal findings of the part itself
[[nodiscard]] core::Findings check_compensated(const solid::Part& part, const profile::Profile& profile, const core::Findings& nominal);

/// Writes k_xx_compensated in each mesh format of the profile, and k_xx_compensated.json, if the profile holds a compensation, and reads
/// them back as the finished part. These files do not carry the law. Always compensates the nominal part, so that nothing is compensated
/// twice.
void write_compensated(PartExport& out, const profile::Profile& profile);

}  // namespace fusee::pipeline
