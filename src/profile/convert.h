#pragma once
#include <toml++/toml.h>

#include <optional>

#include "fusee/core/toml.h"
#include "key.h"

namespace fusee::profile {

/// The node as the key's kind of value in SI. A wrong type, a NaN or a value that is not allowed gives none, and a fault for each number or
/// text.
[[nodiscard]] std::optional<Value> convert(const Key& key, const toml::node& node, core::TomlFaults& faults);

}  // namespace fusee::profile
