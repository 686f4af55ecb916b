#pragma once
#include <string>

#include "fusee/redesign/redesign.h"

/// The consequences of a diagnosis for the cams (docs/guides/close-the-loop.md).
namespace fusee::report {

using profile::Edit, redesign::DeadBandWidths, redesign::NotMended, redesign::Redesign;
using RedesignCover = redesign::Cover;
using RedesignLevel = redesign::Level;
using RedesignProfile = redesign::CorrectedProfile;

/// Keys as docs/guides/close-the-loop.md gives them; a NaN is null.
[[nodiscard]] std::string redesign_json(const Redesign& redesign);
/// A section for the page of the diagnosis.
[[nodiscard]] std::string redesign_section(const Redesign& redesign);
/// A few lines for a terminal.
[[nodiscard]] std::string redesign_text(const Redesign& redesign);

}  // namespace fusee::report
