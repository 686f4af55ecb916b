#pragma once
#include "fusee/pipeline/make.h"
#include "fusee/profile/profile.h"

namespace fusee::app {

/// The design with its parts, in a folder that does not stay. No format beside STL: pictures show none. Refusal and @throws: as
/// pipeline::make_parts.
[[nodiscard]] core::Outcome<pipeline::MadeDesign> made_parts(profile::Profile profile);

}  // namespace fusee::app
