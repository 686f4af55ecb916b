#pragma once
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

/// Text that is seen as it is, in messages, pages and names of files.
namespace fusee::core {

/// `printable` of text.h for each line; line ends and tabs stay. All that a command prints for a person goes through it.
[[nodiscard]] std::string printable_lines(std::string_view text, std::size_t most = std::numeric_limits<std::size_t>::max());

/// A file or folder that fusee makes has a name without terminal controls, marks of writing direction and other characters that are not
/// seen; line ends, tabs and bytes that are no UTF-8 are kept. Folders above it are the user's. @throws IoError
void require_plain_name(const std::filesystem::path& path);

}  // namespace fusee::core
