#pragma once
#include <string>
#include <string_view>

namespace fusee::core {

/// RFC 4648, one line, padded.
[[nodiscard]] std::string base64(std::string_view bytes);
/// The bytes of it; other characters, line ends among them, are skipped.
[[nodiscard]] std::string from_base64(std::string_view text);

}  // namespace fusee::core
