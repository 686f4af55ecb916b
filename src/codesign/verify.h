#pragma once
#include "fusee/pipeline/make.h"

namespace fusee::codesign {

/// Makes a profile with everything that `fusee make` does, solids, rules, files and their reading back, in a temporary folder that is
/// removed again. A design that cannot be made comes back as such. @throws core::IoError
[[nodiscard]] pipeline::MakeResult make_to_verify(const profile::Profile& profile);

}  // namespace fusee::codesign
