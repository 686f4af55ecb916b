#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/drawing/sheet.h"

namespace fusee::drawing {

/// One sheet as SVG 1.1: its unit is the millimetre, and texts are text elements. Equal sheets give equal bytes.
[[nodiscard]] std::string svg(const Sheet& sheet);

/// Every sheet as a page of one PDF, drawn by librsvg and cairo from the same SVG. It has no date: equal sheets give equal bytes on
/// machines with the same libraries and fonts. Thread-safe.
/// @throws IoError if a library cannot draw them
[[nodiscard]] std::string pdf(const std::vector<Sheet>& sheets);

/// `base`.svg with the first sheet, `base`_2.svg with the second and so on. @returns the files written @throws IoError
std::vector<std::filesystem::path> write_svg(const std::filesystem::path& base, const std::vector<Sheet>& sheets);

}  // namespace fusee::drawing
