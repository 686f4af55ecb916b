#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace fusee::core {

/// Text of unknown origin as it may stand in a message: what a terminal would obey (control characters, marks that turn the direction of
/// writing) and bytes that are no UTF-8 become visible, "\n", "\x1b", "\u202e". Of more than `most` characters the first ones stand, then
/// "... (9000000 characters)". Printable text comes back as it is.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = std::numeric_limits<std::size_t>::max());

/// Where the first control character stands, from 0, tab and line ends not counted; npos: nowhere.
[[nodiscard]] std::size_t find_control(std::string_view text);

}  // namespace fusee::core
