#pragma once
#include <string>
#include <vector>

#include "fusee/report/picture.h"

namespace fusee::report {

/// A picture as it stands below its caption.
struct Figure {
    std::string caption;
    double width = 0, height = 0;  ///< drawing units
    std::string content;           ///< of its <svg>
};

/// Figures below each other with their captions, as one SVG. The page's style sheet is inside, with the colours of the theme in the place
/// of its variables, which many readers of SVG do not know.
[[nodiscard]] std::string standalone(const std::vector<Figure>& figures, Theme theme);

}  // namespace fusee::report
