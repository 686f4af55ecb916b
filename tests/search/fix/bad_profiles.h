#pragma once
#include <string>
#include <vector>

#include "pipeline/fixture.h"

/// Known-bad parts as profiles: changes of a good profile that break one rule (tests/checks has the parts worked out by hand).
namespace fusee::fix_each_rule {

struct BadProfile {
    std::string rule;           ///< that is broken; others may be, too
    std::string toml;           ///< names tables next to shipped profiles
    fixtures::Changes spoiled;  ///< keys and values; none: what the shipped profile accepts is not accepted
};

[[nodiscard]] std::vector<BadProfile> bad_profiles();

}  // namespace fusee::fix_each_rule
