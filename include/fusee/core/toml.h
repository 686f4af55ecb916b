#pragma once
#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace fusee::core {

/// Parses TOML 1.0. Text outside strings and comments must be ASCII: bare keys are ASCII, and toml++ 3.3 has undefined behaviour on some
/// others (its issue 295). At most 32 nested brackets and 32 names in a dotted key; texts hold no control characters except tab and line
/// end. `file` is for the message. @throws IoError with line and column
[[nodiscard]] toml::table parse_toml(std::string_view bytes, const std::string& file);

/// A refused value for a message: as TOML, at most 80 characters.
[[nodiscard]] std::string shown(const toml::node& node);

}  // namespace fusee::core
