#pragma once
#include <string>

#include "fusee/gap_case/break_away.h"

/// A gear's friction as files for programs (JSON) and people (HTML, text) (docs/guides/identify-friction.md).
namespace fusee::report {

using gap_case::Identification;

/// The keys of docs/guides/identify-friction.md, in that order; a NaN is null.
[[nodiscard]] std::string identification_json(const Identification& identification);
/// One page in one file that opens offline, with a picture as the paper's figure 8: its scripts inside, no request.
[[nodiscard]] std::string identification_html(const Identification& identification);
/// The lines, remarks and the law for a profile, for a terminal.
[[nodiscard]] std::string identification_text(const Identification& identification);

}  // namespace fusee::report
