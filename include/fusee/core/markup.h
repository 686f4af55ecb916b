#pragma once
#include <string>
#include <string_view>

namespace fusee::core {

/// Text that may stand between tags and in quoted attributes of HTML and SVG.
[[nodiscard]] std::string escape(std::string_view text);
/// Coordinates for SVG: three decimals without trailing zeros (a thousandth of a millimetre or of a pixel).
[[nodiscard]] std::string coordinate(double value);

}  // namespace fusee::core
