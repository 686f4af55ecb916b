#pragma once
#include <string>
#include <string_view>

namespace fusee::core {

/// Demands ASCII outside of strings and comments: TOML 1.0 bare keys are ASCII, and toml++ 3.3 runs into undefined behaviour on some others
/// (its issue 295). `file` is for the message. @throws IoError with line and column
void require_ascii_syntax(std::string_view toml, const std::string& file);

}  // namespace fusee::core
