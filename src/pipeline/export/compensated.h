#pragma once
#include "fusee/core/finding.h"
#include "fusee/pipeline/design.h"
#include "part_export.h"

namespace fusee::pipeline {

/// What the rules say of the part with the bore that its compensated file has, where that is worse than what they say of the nominal one:
/// a wall that a slicer would not fill. Empty without a compensated bore. Rules of the fit on the shaft look at what comes out, the
/// nominal.
/// @param nominal findings of the part itself
[[nodiscard]] core::Findings check_compensated(const solid::Part& part, const profile::Profile& profile, const core::Findings& nominal);

/// Writes k_xx_compensated.stl, .3mf and .json where the profile holds a compensation, and reads them back as they come off the machine;
/// the files stand beside the law. What is compensated is always the nominal part, so that nothing is compensated twice.
void write_compensated(PartExport& out);

}  // namespace fusee::pipeline
