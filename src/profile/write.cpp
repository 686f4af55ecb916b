#include <fmt/format.h>

#include "key.h"
#include "overrides.h"

namespace fusee::profile {

std::string to_toml(const Profile& profile) {
    std::string toml, table;
    for (const Key& key : keys()) {
        if (!applies(key, profile)) continue;
        if (key.table() != table) toml += fmt::format("\n[{}]\n", table = key.table());
        toml += fmt::format("{} = {}\n", key.leaf(), toml_text(key, profile));
    }
    return toml + overrides_toml(profile.limits);
}

}  // namespace fusee::profile
