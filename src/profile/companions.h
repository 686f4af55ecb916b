#pragma once
#include <string>
#include <vector>

#include "fusee/profile/profile.h"

namespace fusee::profile {

/// A key whose value needs other keys above 0: an overhung hub needs its boss.
struct Companions {
    std::string key, value;
    std::vector<std::string> needs;
};

/// The missing companions of the profile's choices, in the order of the keys; `needs` has only the missing keys.
[[nodiscard]] std::vector<Companions> missing_companions(const Profile& profile);

}  // namespace fusee::profile
