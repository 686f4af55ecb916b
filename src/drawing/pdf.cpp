#include "fusee/drawing/sheet.h"
#include "fusee/render/svg.h"

namespace fusee::drawing {

std::string pdf(const std::vector<Sheet>& sheets) {
    std::vector<std::string> pages;
    for (const Sheet& sheet : sheets) pages.push_back(svg(sheet));
    return render::pdf_of_svgs(pages, Sheet::kWidth, Sheet::kHeight, sheets.empty() ? "drawing" : sheets.front().title);
}

}  // namespace fusee::drawing
