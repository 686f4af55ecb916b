#pragma once
#include <string>
#include <vector>

#include "fusee/report/picture.h"

namespace fusee::report {

/// A chart of a page.
struct Figure {
    std::string caption;           ///< as HTML
    std::string content;           ///< of its <svg>
    double width = 0, height = 0;  ///< of its view box
};
/// Every <figure class="plot"> of a piece of a page, in its order.
[[nodiscard]] std::vector<Figure> figures_of(const std::string& html);

/// Charts below each other with their captions, as one SVG. The page's style sheet is inside, with the colours of the theme in the place
/// of its variables, which many readers of SVG do not know.
[[nodiscard]] std::string standalone(const std::vector<Figure>& figures, Theme theme);

}  // namespace fusee::report
