#pragma once
#include <string>
#include <string_view>

namespace fusee::app {

/// Behind each line of a message that begins with "FILE:LINE:COLUMN: ", that line of the file, with a caret below the place. Of the first
/// ten such lines; a file that cannot be read adds nothing.
[[nodiscard]] std::string with_source_lines(std::string_view message);

}  // namespace fusee::app
