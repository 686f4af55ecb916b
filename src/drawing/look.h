#pragma once
#include <array>

/// What the content of a sheet looks like: in the SVG (svg.cpp) as in the PDF (kernel/pdf.cpp).
namespace fusee::drawing {

struct PenLook {
    const char* name;  ///< of its class in the SVG
    double width_mm;
    std::array<double, 4> dashes_mm;  ///< line, gap, line, gap; none: continuous
    int dashes;                       ///< how many of these
};
inline constexpr PenLook kPens[] = {{"outline", 0.5, {}, 0},
                                    {"thin", 0.18, {}, 0},
                                    {"hidden", 0.25, {2.4, 1.0}, 2},
                                    {"centre", 0.18, {7.0, 1.0, 0.6, 1.0}, 4},
                                    {"cut", 0.7, {}, 0}};  // by Pen

inline constexpr double kArrowLength = 2.5, kArrowHalfWidth = 0.42;  // [mm]

// Named before the family, since only few fonts have the width of `width_of`.
inline constexpr const char* kFonts[] = {"DejaVu Sans Mono", "Liberation Mono", "Courier New", "monospace"};

}  // namespace fusee::drawing
