#pragma once
#include <string>
#include <vector>

#include "fusee/profile/profile.h"

namespace fusee::profile {

/// A key whose value asks for others above 0: an overhung hub for its boss.
struct Companions {
    std::string key, value;
    std::vector<std::string> needs;
};

/// What the profile's choices ask for and do not have, in the order of the keys; `needs` holds only what is missing.
[[nodiscard]] std::vector<Companions> missing_companions(const Profile& profile);

}  // namespace fusee::profile
