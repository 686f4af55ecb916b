#pragma once
#include <string>
#include <vector>

/// SVG to other formats, by librsvg and cairo. Texts use the fonts of the machine: equal input gives equal bytes on machines with the same
/// libraries and fonts. Thread-safe.
namespace fusee::render {

/// Draws an SVG on white. @param longest_px width or height, whichever is larger @throws IoError naming `name`
[[nodiscard]] std::string png_of_svg(const std::string& svg, const std::string& name, int longest_px);

/// Each SVG as a page of one PDF without a date. @param title of the document @throws IoError naming it
[[nodiscard]] std::string pdf_of_svgs(const std::vector<std::string>& pages, double width_mm, double height_mm, const std::string& title);

}  // namespace fusee::render
