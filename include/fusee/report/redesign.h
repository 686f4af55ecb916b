#pragma once
#include <string>

#include "fusee/search/redesign.h"

/// The consequences of a diagnosis for the cams (docs/guides/close-the-loop.md).
namespace fusee::report {

using profile::Edit, search::redesign::DeadBandWidths, search::redesign::NotMended, search::redesign::Redesign;
using RedesignCover = search::redesign::Cover;
using RedesignLevel = search::redesign::Level;
using RedesignProfile = search::redesign::CorrectedProfile;

/// Keys as docs/guides/close-the-loop.md gives them; a NaN is null.
[[nodiscard]] std::string redesign_json(const Redesign& redesign);
/// "covers 0.9 to 1.31 Nm of the 0.85 to 1.5 Nm in use: ..."; "" if it is not known.
[[nodiscard]] std::string coverage(const RedesignCover& cover);
/// A few lines for a terminal.
[[nodiscard]] std::string redesign_text(const Redesign& redesign);

}  // namespace fusee::report
