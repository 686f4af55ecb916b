#pragma once
#include "fusee/drawing/drawing.h"

namespace fusee::drawing {

/// Left and upper edge of the title block in the frame's lower right corner.
inline constexpr Point kTitleCorner{230.0, 230.0};

/// Above the title block: the roughness of all faces that say nothing else, and the state of their edges.
void draw_general_marks(Sheet& sheet, const Subject& subject);

/// What the title block says of the body alone.
struct Titled {
    std::string title;
    double chordal_mm;  ///< of its mesh
};
/// Of a cam.
[[nodiscard]] Titled title_of(const Subject& subject);
/// Frame and title block (ISO 7200) with the symbol of first-angle projection (ISO 5456-2).
void draw_title(Sheet& sheet, const Subject& subject, const Titled& body, double scale, std::size_t number, std::size_t count);

}  // namespace fusee::drawing
