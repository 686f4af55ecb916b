#pragma once
#include <toml++/toml.h>

#include <string>

#include "key.h"

namespace fusee::profile {

/// "pnrvsa.toml:12:5: rig.gear_friction", the way in which every mistake is named.
[[nodiscard]] std::string place(const std::string& file, const toml::source_region& at, std::string_view path);

/// The node as the key's kind of value in SI. @throws core::InvalidInput on a wrong type, NaN or a value that is not allowed
[[nodiscard]] Value convert(const Key& key, const toml::node& node, const std::string& file);

}  // namespace fusee::profile
