#pragma once
#include <string>

#include "fusee/identification/break_away.h"

/// A gear's friction as identified, to files that a program (JSON) or a person (HTML, text) reads (docs/guides/identify-friction.md).
namespace fusee::report {

/// What the figures come from.
struct Identification {
    std::string name;         ///< of the file, without its ending
    std::string file_sha256;  ///< of the CSV as read
    identification::FrictionReport friction;
};

/// The keys of docs/guides/identify-friction.md, in that order; a NaN is null.
[[nodiscard]] std::string identification_json(const Identification& identification);
/// One page in one file that opens offline, with a picture as the paper's figure 8: no script, no request.
[[nodiscard]] std::string identification_html(const Identification& identification);
/// The lines, remarks and the law for a profile, for a terminal.
[[nodiscard]] std::string identification_text(const Identification& identification);

}  // namespace fusee::report
