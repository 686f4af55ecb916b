#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/path.h"

/// Text that is seen as it is, in messages, pages and names of files; names that are near; text in other encodings.
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

/// One word for a POSIX shell: 'a b'; a word that needs no quotes has none.
[[nodiscard]] std::string shell_word(std::string_view text);

/// Index of the first control character other than tab and line end; npos: none.
[[nodiscard]] std::size_t find_control(std::string_view text);

/// One character of a text: a code point of UTF-8, or an invalid byte.
struct Character {
    std::size_t bytes = 1;
    char32_t code = 0;
    bool valid = true;
};
/// The character at the beginning. @pre !text.empty()
[[nodiscard]] Character first_character(std::string_view text);

/// The words between blanks, tabs and line ends.
[[nodiscard]] std::vector<std::string> words_of(std::string_view text);

/// ASCII letters in lower case, all else as it is.
[[nodiscard]] std::string lower(std::string_view text);

/// Number of letters of valid UTF-8.
[[nodiscard]] std::size_t letters(std::string_view text);

/// `printable` for each line; line ends and tabs stay. All that a command prints for a person goes through it.
[[nodiscard]] std::string printable_lines(std::string_view text, std::size_t most = std::numeric_limits<std::size_t>::max());

/// A file or folder that fusee makes has a name without terminal controls, marks of writing direction and other characters that are not
/// seen; line ends, tabs and bytes that are no UTF-8 are kept. Folders above it are the user's. @throws IoError
void require_plain_name(const std::filesystem::path& path);

/// Least number of letters to insert, delete, replace or swap with the next one (optimal string alignment).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The names that a person may have meant by `asked`, nearest first, at most `most`; of equally near ones the earlier first. Near is a name
/// that differs by a third of its letters at most, or that begins with `asked` of three letters or more; capitals do not count. Empty: no
/// name is near.
[[nodiscard]] std::vector<std::string> near_names(std::string_view asked, const std::vector<std::string>& names, std::size_t most = 3);

/// "; did you mean make or fix?"; "" if no name is near. `quote` stands around each name.
[[nodiscard]] std::string did_you_mean(std::string_view asked, const std::vector<std::string>& names, std::string_view quote = "");

/// Text that may stand between tags and in quoted attributes of HTML and SVG.
[[nodiscard]] std::string escape(std::string_view text);
/// Coordinates for SVG: three decimals without trailing zeros (a thousandth of a millimetre or of a pixel).
[[nodiscard]] std::string coordinate(double value);

/// RFC 4648, one line, padded.
[[nodiscard]] std::string base64(std::string_view bytes);
/// The bytes of it; other characters, line ends among them, are skipped.
[[nodiscard]] std::string from_base64(std::string_view text);

}  // namespace fusee::core
