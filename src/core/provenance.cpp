#include "fusee/core/provenance.h"

#include <fmt/format.h>

namespace fusee::core {

const char* version() { return FUSEE_VERSION; }

std::string Provenance::line() const {
    return fmt::format("fusee {}, {}, profile {}{}{}", version(), name, profile_sha256.substr(0, 12), options.empty() ? "" : ", ", options);
}

}  // namespace fusee::core
