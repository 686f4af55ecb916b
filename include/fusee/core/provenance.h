#pragma once
#include <string>

namespace fusee::core {

/// The released version, e.g. "0.1.0".
[[nodiscard]] const char* version();

/// Stamp of every output: the program and the profile that made it. It has no time, so that equal input gives equal bytes.
struct Provenance {
    std::string name;            ///< the design's name
    std::string profile_sha256;  ///< of the profile as read, with the CSV files it names
    std::string options;         ///< command-line options that change the result, e.g. "via=cgal"
    /// "fusee 0.1.0, pnrvsa, profile 1a2b3c4d5e6f, via=cgal"
    [[nodiscard]] std::string line() const;
};

}  // namespace fusee::core
