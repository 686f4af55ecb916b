#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace fusee::core {

/// UTF-8 text files may begin with it.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Text of unknown origin, safe for a message: control characters, marks of writing direction and invalid UTF-8 become visible, "\n",
/// "\x1b", "\u202e". Text of more than `most` characters is cut and ends with "... (9000000 characters)". Printable text is unchanged.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = std::numeric_limits<std::size_t>::max());

/// "1 error", "2 errors"
[[nodiscard]] std::string counted(std::size_t n, std::string_view what);

/// "999 B", "12.3 kB", "1.25 GB"
[[nodiscard]] std::string bytes_text(double bytes);

/// One word for a POSIX shell: 'a b'.
[[nodiscard]] std::string shell_word(std::string_view text);

/// Index of the first control character other than tab and line end; npos: none.
[[nodiscard]] std::size_t find_control(std::string_view text);

/// Number of letters of valid UTF-8.
[[nodiscard]] std::size_t letters(std::string_view text);

}  // namespace fusee::core
